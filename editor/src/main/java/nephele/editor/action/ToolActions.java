package nephele.editor.action;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.session.Tools;
import nephele.editor.text.Words;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.clip.ClipTool;

/** Taking a tool: one action for each. */
final class ToolActions {
    static final List<EditorAction> ALL = all();

    private ToolActions() {}

    private static List<EditorAction> all() {
        List<EditorAction> actions = new ArrayList<>();
        for (ToolEntry entry : Tools.ALL) {
            List<String> keys = entry.key().isEmpty() ? List.of() : List.of(entry.key());
            actions.add(EditorAction.of("tool-" + entry.id(), entry.title(), Menu.TOOL, keys, call -> call.session()
                    .use(entry)));
        }
        actions.add(EditorAction.of(
                "cancel",
                Words.of("Cancel the Drag", "Cancelar o arraste", "Cancelar o arrasto"),
                Menu.TOOL,
                List.of("Escape"),
                call -> {
                    call.session().tool().cancel();
                    call.session().proving().dismiss();
                }));
        actions.add(EditorAction.of(
                        "clip-keep",
                        Words.of("Clip: Keep Another Part", "Cortar: manter outra parte", "Cortar: manter outra parte"),
                        Menu.TOOL,
                        List.of("Shift+C"),
                        call -> keepAnotherPart(call.session()))
                .when(session -> session.tool() instanceof ClipTool));
        return List.copyOf(actions);
    }

    private static void keepAnotherPart(EditorSession session) {
        if (session.tool() instanceof ClipTool clip) {
            clip.cycle();
            session.tell(SessionChange.VIEW);
        }
    }
}
