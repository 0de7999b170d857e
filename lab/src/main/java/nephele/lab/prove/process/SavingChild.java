package nephele.lab.prove.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;

/** A process that saves one level after another until it is killed. */
final class SavingChild {
    /** A limit at which the process ends by itself, in case its parent has ended without killing it. */
    private static final int MOST_SAVES = 5_000;

    private SavingChild() {}

    /** Written when a save begins; {@link #ENDED} when it has ended. */
    static final char BEGUN = '(';

    static final char ENDED = ')';

    /** Saves to the given file and writes when each save begins and ends. */
    public static void main(String[] arguments) throws IOException {
        Path file = Path.of(arguments[0]);
        for (int generation = 1; generation <= MOST_SAVES; generation++) {
            Level level = level(generation);
            tell(BEGUN);
            LevelFile.save(file, level);
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

    /** Returns a level of changing size, named by its number. */
    static Level level(int generation) {
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
}
