package nephele.editor.action;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.session.EditorSession;
import nephele.editor.tool.ToolEntry;

/** The commands of a session: the tools in the toolbar's order, then the actions in the menus' order. */
public final class EditorCommands {
    private final List<EditorCommand> all = new ArrayList<>();
    private final EditorSession session;
    private final Desk desk;

    /** Tools for which {@code actions} has an action {@code tool-<id>} of their own are not added again. */
    public EditorCommands(EditorSession session, Desk desk, List<EditorAction> actions, List<ToolEntry> tools) {
        this.session = session;
        this.desk = desk;
        Set<String> ids = actions.stream().map(EditorAction::id).collect(Collectors.toSet());
        tools.stream()
                .filter(tool -> !ids.contains(EditorCommand.TOOL + tool.id()))
                .forEach(tool -> all.add(taking(tool)));
        actions.forEach(action -> all.add(running(action)));
    }

    private EditorCommand taking(ToolEntry tool) {
        return new EditorCommand(
                EditorCommand.TOOL + tool.id(),
                tool.title(),
                tool.description(),
                Menu.TOOL,
                tool.key().isEmpty() ? List.of() : List.of(tool.key()),
                () -> true,
                () -> session.toolEntry().id().equals(tool.id()),
                () -> session.use(tool));
    }

    private EditorCommand running(EditorAction action) {
        return new EditorCommand(
                action.id(),
                action.title(),
                action.title(),
                action.menu(),
                action.keys(),
                () -> action.isEnabled().test(session),
                () -> ActionStates.isChosen(action.id(), session),
                () -> run(action));
    }

    private void run(EditorAction action) {
        if (!action.endDrag(session) || desk.asks(action.id())) {
            return;
        }
        try {
            action.run(new ActionCall(session, desk, Map.of()));
        } catch (ActionFailure failure) {
            session.status(failure.told());
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
}
