package nephele.editor.action;

import java.util.List;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.text.Words;

/** Parts of the window that ask or tell something; a script has none of them. */
final class WindowActions {
    static final List<EditorAction> ALL = List.of(
            shown("turn-by", Words.of("Turn by…", "Girar em…", "Rodar em…"), Menu.EDIT, List.of("Ctrl+Alt+R"))
                    .when(EditActions::hasSelection),
            shown("settings", Words.of("Settings…", "Configurações…", "Definições…"), Menu.EDIT, List.of("Ctrl+Comma")),
            shown(
                    "guide",
                    Words.of("Guide: Your First Room", "Guia: sua primeira sala", "Guia: a tua primeira sala"),
                    Menu.HELP,
                    List.of("F1")),
            shown(
                    "palette",
                    Words.of("Search Commands…", "Buscar comandos…", "Procurar comandos…"),
                    Menu.HELP,
                    List.of("Ctrl+K", "Ctrl+Shift+P")),
            shown("keys", Words.of("Keys…", "Teclas…", "Teclas…"), Menu.HELP, List.of()));

    private WindowActions() {}

    private static EditorAction shown(String id, Words title, Menu menu, List<String> keys) {
        return EditorAction.of(id, title, menu, keys, call -> call.desk().show(id))
                .changing(Subject.WINDOW);
    }
}
