package nephele.workshop.prove.editor;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import nephele.editor.document.Document;
import nephele.editor.document.EntityTransform;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.editor.save.Backups;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.DocumentSaver;
import nephele.editor.save.SaveResult;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.process.TemporaryFolder;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Opens a copy of every level file, saves it unchanged, renamed, and with its last solid moved, and compares the texts. */
public final class EditorOpenSaveProof implements Proof {
    private static final Words EDIT = Words.same("edit");
    private static final Path LEVELS = Path.of("levels");
    private static final String NEW_NAME = "Another name";

    @Override
    public Claim claim() {
        return new Claim(
                "editor-open-save",
                "Every level file that is opened and saved keeps every byte, or if it is not in canonical form every"
                        + " value; after one edit (the name, a solid moved) only the lines of what was edited differ.",
                "level files",
                () -> files().size(),
                100);
    }

    /** Returns the level files of the checkout in order of their paths. */
    static List<Path> files() {
        try (var all = Files.walk(LEVELS)) {
            return all.filter(file -> file.toString().endsWith(".json"))
                    .filter(EditorOpenSaveProof::isLevel)
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static boolean isLevel(Path file) {
        try {
            return Files.readString(file).contains("\"format\": \"nephele-level\"");
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        List<Path> files = files().subList((int) from, (int) (from + count));
        Path folder = Files.createTempDirectory("nephele-open-save");
        long canonical = 0;
        long edits = 0;
        try {
            for (Path file : files) {
                Trial trial = new Trial(file, folder);
                trial.run();
                failures.addAll(trial.failures);
                canonical += trial.isCanonical ? 1 : 0;
                edits += trial.edits;
                progress.unitsDone(files.indexOf(file) + 1L);
            }
        } finally {
            TemporaryFolder.delete(folder);
        }
        return ProofResult.of(
                count, failures, Figure.sum("in canonical form", canonical, ""), Figure.sum("edits", edits, ""));
    }

    /** One level file. */
    private static final class Trial {
        private final Path source;
        private final Path copy;
        private final DocumentSaver saver;
        private final List<String> failures = new ArrayList<>();
        private boolean isCanonical;
        private int edits;

        Trial(Path source, Path folder) {
            this.source = source;
            copy = folder.resolve("level.json");
            saver = new DocumentSaver(new Backups(folder.resolve("backups"), InstantSource.system()));
        }

        void run() throws Exception {
            String original = Files.readString(source);
            Level level = DocumentFile.open(source.toString()).level();
            String form = LevelJson.write(level);
            isCanonical = form.equals(original);
            String kept = saved(same -> same);
            if (!kept.equals(isCanonical ? original : form)) {
                failures.add(source + ": is not the same after it was opened and saved");
            }
            if (!LevelJson.read(source.toString(), kept.getBytes(StandardCharsets.UTF_8))
                    .equals(level)) {
                failures.add(source + ": the values are not the same after it was opened and saved");
            }
            String renamed = saved(Trial::renamed);
            requireOnly(form, renamed, member(lines(form), "name"));
            if (!level.solids().isEmpty()) {
                String id = level.solids().get(level.solids().size() - 1).id();
                requireOnly(form, saved(before -> moved(before, id)), solid(lines(form), id));
            }
        }

        private static Level renamed(Level level) {
            RecordKind kind = RecordKind.of(level);
            return kind.with(level, kind.field("name").orElseThrow(), NEW_NAME);
        }

        private static Level moved(Level level, String solid) {
            return EntityTransform.moved(level, List.of(new EntityRef("solids", solid)), new Vec3(0.5, 0, 0), false);
        }

        /** Returns the text of a copy that was opened, edited and saved. */
        private String saved(UnaryOperator<Level> edit) throws Exception {
            Files.copy(source, copy, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
            DocumentFile.Opened opened = DocumentFile.open(copy.toString());
            Document document = new Document(opened.level());
            document.edit(EDIT, edit);
            SaveResult result = saver.save(opened.file(), document.level());
            if (!(result instanceof SaveResult.Saved)) {
                failures.add(source + ": could not be saved: " + result);
            }
            return Files.readString(copy);
        }

        private void requireOnly(String before, String after, Optional<Block> allowed) {
            edits++;
            Block changed = changed(lines(before), lines(after));
            if (changed.isEmpty() || allowed.isEmpty() || !allowed.get().contains(changed)) {
                failures.add(source + ": an edit of lines " + allowed + " changed lines " + changed);
            }
        }
    }

    private static List<String> lines(String text) {
        return text.lines().toList();
    }

    /** Lines of a text from one, inclusive, to another, exclusive. */
    private record Block(int from, int to) {
        boolean isEmpty() {
            return from == to;
        }

        boolean contains(Block other) {
            return other.from >= from && other.to <= to;
        }
    }

    /** Returns the block between the first lines and the last lines that both texts have. */
    private static Block changed(List<String> before, List<String> after) {
        int shorter = Math.min(before.size(), after.size());
        int head = 0;
        while (head < shorter && before.get(head).equals(after.get(head))) {
            head++;
        }
        int tail = 0;
        while (tail < shorter - head
                && before.get(before.size() - 1 - tail).equals(after.get(after.size() - 1 - tail))) {
            tail++;
        }
        return new Block(head, before.size() - tail);
    }

    /** Returns the line of a member of the level itself. */
    private static Optional<Block> member(List<String> lines, String name) {
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).startsWith("  \"" + name + "\":")) {
                return Optional.of(new Block(i, i + 1));
            }
        }
        return Optional.empty();
    }

    /** Returns the lines of a solid, from its brace to the closing one. */
    private static Optional<Block> solid(List<String> lines, String id) {
        int section = lines.indexOf("  \"solids\": [");
        for (int i = Math.max(0, section); i < lines.size(); i++) {
            if (lines.get(i).startsWith("      \"id\": \"" + id + "\"")) {
                int end = i;
                while (!lines.get(end).startsWith("    }")) {
                    end++;
                }
                return Optional.of(new Block(i - 1, end + 1));
            }
        }
        return Optional.empty();
    }
}
