package nephele.workshop.prove.process;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.host.userfile.UserFile;

/** A kind of file that is saved in generations, each with a content of its own size. */
enum SavedFile {
    LEVEL("save-kills", "Killing the process at any moment of a save leaves a complete old or new level file.") {
        @Override
        void save(Path file, int generation) {
            LevelFile.save(file, level(generation));
        }

        @Override
        String problem(Path file) {
            try {
                Level found = LevelFile.read(file);
                return found.equals(level(Integer.parseInt(found.name())))
                        ? null
                        : "the file holds a level that was never saved";
            } catch (LevelFormatException | NumberFormatException unreadable) {
                return unreadable.getMessage();
            }
        }
    },
    PLAYER(
            "settings-kills",
            "Killing the process at any moment of a save leaves complete old or new settings, unknown entries"
                    + " included.") {
        @Override
        void save(Path file, int generation) throws IOException {
            new UserFile(file, "nephele-settings", 1).save(entries(generation));
        }

        @Override
        String problem(Path file) {
            List<String> problems = new ArrayList<>();
            JsonObject found = new UserFile(file, "nephele-settings", 1).read(problems::add);
            if (!problems.isEmpty()) {
                return problems.toString();
            }
            return found.has("generation")
                            && found.equals(entries(found.get("generation").getAsInt()))
                    ? null
                    : "the file holds entries that were never saved";
        }
    };

    /** A limit at which a saving process ends by itself, in case its parent has ended without killing it. */
    private static final int MOST_SAVES = 5_000;

    /** Written when a save begins; {@link #ENDED} when it has ended. */
    static final char BEGUN = '(';

    static final char ENDED = ')';

    private final String proof;
    private final String claim;

    SavedFile(String proof, String claim) {
        this.proof = proof;
        this.claim = claim;
    }

    String proof() {
        return proof;
    }

    String claim() {
        return claim;
    }

    /** Saves the content of a generation. */
    abstract void save(Path file, int generation) throws IOException;

    /** Returns why the file, not its backup, is no complete generation; {@code null} if it is one. */
    abstract String problem(Path file);

    private static JsonObject entries(int generation) {
        JsonObject entries = new JsonObject();
        entries.addProperty("generation", generation);
        for (int i = 0; i < generation * 37 % 200; i++) {
            entries.addProperty("unknown entry " + i, "kept " + generation);
        }
        return entries;
    }

    private static Level level(int generation) {
        StringBuilder json = new StringBuilder("{\"format\": \"nephele-level\", \"version\": 1, \"name\": \"");
        json.append(generation).append("\", \"solids\": [");
        for (int i = 0; i < generation * 37 % 200; i++) {
            json.append(i == 0 ? "" : ",")
                    .append("{\"id\": \"s")
                    .append(i)
                    .append("\", \"kind\": \"box\", \"centre\": [")
                    .append(i)
                    .append(", 0.5, ")
                    .append(generation)
                    .append("], \"size\": [1, 1, 1]}");
        }
        return LevelJson.read("generated", json.append("]}").toString().getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Saves one generation after another until the process is killed, and writes when each save begins and ends.
     *
     * @param arguments the constant's name and the file
     */
    public static void main(String[] arguments) throws IOException {
        SavedFile kind = SavedFile.valueOf(arguments[0]);
        Path file = Path.of(arguments[1]);
        for (int generation = 1; generation <= MOST_SAVES; generation++) {
            tell(BEGUN);
            kind.save(file, generation);
            tell(ENDED);
            if (System.out.checkError()) {
                return;
            }
        }
    }

    private static void tell(char what) {
        System.out.write(what);
        System.out.flush();
    }
}
