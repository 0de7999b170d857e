package nephele.editor.window.dialog;

import java.nio.file.Path;
import java.text.Normalizer;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.editor.panel.model.PaletteEntry;
import nephele.editor.record.Entities;
import nephele.engine.level.Language;

/** The search lists of the editor. */
public final class Searches {
    private Searches() {}

    /** Returns the search over all commands, with menu and key of each. */
    public static SearchList<EditorCommand> commands(
            List<EditorCommand> commands, EditorKeys keys, Language language, Consumer<Optional<EditorCommand>> done) {
        return new SearchList<>(
                DialogText.SEARCH_COMMANDS,
                query -> EditorCommands.find(commands, query, language),
                command -> new SearchList.Row(
                        command.title().in(language),
                        command.menu().title().in(language),
                        keys.of(command.id()).stream()
                                .findFirst()
                                .map(KeyText::text)
                                .orElse(""),
                        null,
                        command.isEnabled().getAsBoolean()),
                done,
                language);
    }

    /** Returns the search over all kinds of entities that a level can have. */
    public static SearchList<PaletteEntry> kinds(Language language, Consumer<Optional<PaletteEntry>> done) {
        List<PaletteEntry> all = PaletteEntry.all(Entities.LEVEL);
        return new SearchList<>(
                DialogText.SEARCH_KINDS,
                query -> all.stream()
                        .filter(entry -> hasWords(
                                query, entry.words().in(language), entry.words().english(), entry.section()))
                        .toList(),
                entry -> SearchList.Row.of(
                        entry.words().in(language), entry.sectionWords().in(language)),
                done,
                language);
    }

    /** Returns the search over files, by name, with the folder of each. */
    public static SearchList<Path> files(List<Path> files, Language language, Consumer<Optional<Path>> done) {
        return new SearchList<>(
                DialogText.SEARCH_FILES,
                query -> files.stream()
                        .filter(file -> hasWords(query, file.toString()))
                        .toList(),
                file -> SearchList.Row.of(
                        file.getFileName().toString(), file.getParent().toString()),
                done,
                language);
    }

    /** Returns true if every word of a query is in one of the texts; accents and case do not matter. */
    public static boolean hasWords(String query, String... texts) {
        String all = folded(String.join(" ", texts));
        return Arrays.stream(folded(query).trim().split("\\s+")).allMatch(all::contains);
    }

    private static String folded(String text) {
        return Normalizer.normalize(text, Normalizer.Form.NFD)
                .replaceAll("\\p{M}", "")
                .toLowerCase(Locale.ROOT);
    }
}
