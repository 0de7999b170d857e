package nephele.editor.action;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.pane.PaneLayout.Arrangement;
import nephele.editor.pane.ViewMode;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.Language;

/** The commands of a session, in the order of the menus. */
public final class EditorCommands {
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

    private final List<EditorCommand> all = new ArrayList<>();
    private final EditorSession session;
    private final UserInterface ui;

    public EditorCommands(EditorSession session, UserInterface ui, List<EditorAction> actions) {
        this.session = session;
        this.ui = ui;
        actions.forEach(action -> all.add(running(action)));
    }

    private EditorCommand running(EditorAction action) {
        return new EditorCommand(
                action.id(),
                action.title(),
                action.title(),
                action.menu(),
                action.keys(),
                () -> action.isEnabled().test(session),
                () -> isChosen(action.id(), session),
                () -> run(action));
    }

    private void run(EditorAction action) {
        if (!action.endDrag(session) || ui.asks(action.id())) {
            return;
        }
        try {
            action.run(new ActionCall(session, ui, Map.of()));
        } catch (EditorRefusal failure) {
            session.status(failure.words());
        }
    }

    /** Returns all commands. */
    public List<EditorCommand> all() {
        return List.copyOf(all);
    }

    /** Returns the commands of a menu. */
    public List<EditorCommand> in(Menu menu) {
        return all.stream().filter(command -> command.menu() == menu).toList();
    }

    public Optional<EditorCommand> named(String id) {
        return all.stream().filter(command -> command.id().equals(id)).findFirst();
    }

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
    private static boolean isChosen(String action, EditorSession session) {
        return ("tool-" + session.toolEntry().id()).equals(action)
                || ProvingActions.isOn(session, action)
                || VIEWS.getOrDefault(action, any -> false).test(session)
                || OptionActions.CHOSEN.getOrDefault(action, any -> false).test(session)
                || TerrainActions.CHOSEN.getOrDefault(action, any -> false).test(session);
    }

    /** Returns the commands that have every word of a query, those whose title begins with it first. */
    public static List<EditorCommand> find(List<EditorCommand> commands, String query, Language language) {
        String wanted = folded(query).trim();
        List<String> words =
                Arrays.stream(wanted.split("\\s+")).filter(w -> !w.isEmpty()).toList();
        return commands.stream()
                .filter(command -> words.stream().allMatch(searched(command, language)::contains))
                .sorted(Comparator.comparingInt(command -> rank(command, wanted, language)))
                .toList();
    }

    private static String searched(EditorCommand command, Language language) {
        return folded(command.title().in(language)
                + " "
                + command.title().english()
                + " "
                + command.menu().title().in(language)
                + " "
                + command.id());
    }

    private static int rank(EditorCommand command, String wanted, Language language) {
        String title = folded(command.title().in(language));
        return title.startsWith(wanted) ? 0 : title.contains(wanted) ? 1 : 2;
    }

    private static String folded(String text) {
        return Normalizer.normalize(text, Normalizer.Form.NFD)
                .replaceAll("\\p{M}", "")
                .toLowerCase(Locale.ROOT);
    }
}
