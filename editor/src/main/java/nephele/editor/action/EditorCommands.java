package nephele.editor.action;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.Language;

/** The commands of a session, in the order of the menus. */
public final class EditorCommands {
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
                action.menu(),
                action.keys(),
                () -> action.isEnabled().test(session),
                () -> action.isChosen().test(session),
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
