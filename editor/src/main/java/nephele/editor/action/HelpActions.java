package nephele.editor.action;

import java.util.List;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.text.Words;

/** The guide and what else explains the editor. */
final class HelpActions {
    static final List<EditorAction> ALL = List.of(EditorAction.of(
            "guide",
            Words.of("Guide: Your First Room", "Guia: sua primeira sala", "Guia: a tua primeira sala"),
            Menu.HELP,
            List.of("F1"),
            call -> call.desk().show("guide")));

    private HelpActions() {}
}
