package nephele.editor.action;

import java.util.Map;
import java.util.function.Predicate;
import nephele.editor.pane.PaneLayout.Arrangement;
import nephele.editor.pane.ViewMode;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.engine.level.Language;

/** The states that menus and toolbars show: which of several choices holds now. */
public final class ActionStates {
    private static final Map<String, Predicate<EditorSession>> VIEWS = Map.ofEntries(
            Map.entry("lit", mode(ViewMode.LIT)),
            Map.entry("unlit", mode(ViewMode.UNLIT)),
            Map.entry("portalable", mode(ViewMode.PORTALABLE)),
            Map.entry("collision", mode(ViewMode.COLLISION)),
            Map.entry("wireframe", mode(ViewMode.WIREFRAME)),
            Map.entry("one-pane", panes(Arrangement.ONE)),
            Map.entry("two-panes", panes(Arrangement.TWO)),
            Map.entry("four-panes", panes(Arrangement.FOUR)),
            Map.entry("maximise", session -> session.panes().isMaximised()),
            Map.entry("guide-lines", session -> session.settings().get(EditorSetting.GUIDE_LINES)),
            Map.entry("theme-light", theme(Theme.LIGHT)),
            Map.entry("theme-dark", theme(Theme.DARK)),
            Map.entry("language-en", language(Language.EN)),
            Map.entry("language-pt-br", language(Language.PT_BR)),
            Map.entry("language-pt-pt", language(Language.PT_PT)));

    private ActionStates() {}

    private static Predicate<EditorSession> mode(ViewMode mode) {
        return session -> session.panes().activeView().mode() == mode;
    }

    private static Predicate<EditorSession> panes(Arrangement arrangement) {
        return session -> session.panes().arrangement() == arrangement;
    }

    private static Predicate<EditorSession> theme(Theme theme) {
        return session -> session.settings().get(EditorSetting.THEME) == theme;
    }

    private static Predicate<EditorSession> language(Language language) {
        return session -> session.language() == language;
    }

    /** Returns true if the choice that an action makes holds now; false for an action that makes none. */
    public static boolean isChosen(String action, EditorSession session) {
        return ("tool-" + session.toolEntry().id()).equals(action)
                || ProvingActions.isOn(session, action)
                || VIEWS.getOrDefault(action, any -> false).test(session)
                || OptionActions.CHOSEN.getOrDefault(action, any -> false).test(session)
                || TerrainActions.CHOSEN.getOrDefault(action, any -> false).test(session);
    }
}
