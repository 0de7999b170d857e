package nephele.editor.action;

import java.text.Normalizer;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import nephele.engine.level.Language;

/** Finds commands by words of their titles, menus and ids; accents and case do not matter. */
public final class CommandSearch {
    private CommandSearch() {}

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
