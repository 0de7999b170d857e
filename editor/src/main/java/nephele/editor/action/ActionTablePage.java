package nephele.editor.action;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.asset.AtomicFile;

/** The page docs/editor-keys.md, made from the action table. */
public final class ActionTablePage {
    private ActionTablePage() {}

    /** Writes the page to the file that the first argument names. */
    public static void main(String[] arguments) throws IOException {
        AtomicFile.write(Path.of(arguments[0]), text().getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the page as Markdown. */
    public static String text() {
        StringBuilder page = new StringBuilder(
                """
                # Actions and keys of the editor

                Generated from the action table (`./gradlew editorKeys`). Every action can be run by its name in a script,
                `edit LEVEL --script F`, with its parameters as `key=value`; the first parameter's key may be left out. Ctrl is
                Command on macOS.
                """);
        for (EditorAction.Menu menu : EditorAction.Menu.values()) {
            if (Actions.ALL.stream().anyMatch(action -> action.menu() == menu)) {
                page.append("\n## ")
                        .append(menu.title().english())
                        .append("\n\n| action | does | keys | parameters |\n|---|---|---|---|\n");
                Actions.ALL.stream().filter(action -> action.menu() == menu).forEach(action -> row(page, action));
            }
        }
        return page.toString();
    }

    private static void row(StringBuilder page, EditorAction action) {
        page.append("| `")
                .append(action.id())
                .append("` | ")
                .append(action.title().english())
                .append(" | ");
        page.append(String.join(", ", action.keys())).append(" | ");
        page.append(String.join(
                ", ", action.parameters().stream().map(name -> "`" + name + "`").toList()));
        page.append(" |\n");
    }
}
