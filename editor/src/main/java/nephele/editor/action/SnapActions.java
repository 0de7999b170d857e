package nephele.editor.action;

import java.util.List;
import java.util.Set;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.text.Words;
import nephele.editor.tool.ToolOptions.Snapping;

/** The targets of snapping, each turned on and off. */
final class SnapActions {
    private static final Words ON = Words.of("%s: on", "%s: ligado", "%s: ligado");
    private static final Words OFF = Words.of("%s: off", "%s: desligado", "%s: desligado");

    static final List<EditorAction> ALL = List.of(
            toggle("grid", Words.of("Snap to Grid", "Encaixar na grade", "Encaixar na grelha"), Snapping.GRID, "1"),
            toggle(
                    "vertex",
                    Words.of("Snap to Vertices", "Encaixar em vértices", "Encaixar em vértices"),
                    Snapping.VERTEX,
                    "2"),
            toggle(
                    "surface",
                    Words.of("Snap to Surfaces", "Encaixar em superfícies", "Encaixar em superfícies"),
                    Snapping.SURFACE,
                    "3"),
            toggle(
                    "absolute",
                    Words.of("Snap onto the Grid", "Encaixar sobre a grade", "Encaixar sobre a grelha"),
                    Snapping.ABSOLUTE,
                    "4"));

    private SnapActions() {}

    private static EditorAction toggle(String id, Words title, Snapping target, String digit) {
        return EditorAction.of(
                "snap-" + id,
                title,
                Menu.TOOL,
                List.of("Alt+Shift+" + digit),
                call -> toggle(call.session(), title, target));
    }

    private static void toggle(EditorSession session, Words title, Snapping target) {
        Set<Snapping> targets = session.options().snapping();
        boolean isOn = !targets.remove(target) && targets.add(target);
        Words state = isOn ? ON : OFF;
        session.status(Words.of(
                state.with(title.english()).english(),
                state.with(title.brazilian()).brazilian(),
                state.with(title.european()).european()));
        session.tell(Change.VIEW);
    }
}
