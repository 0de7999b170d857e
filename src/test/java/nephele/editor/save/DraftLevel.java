package nephele.editor.save;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;

/** Small levels that differ in one number, as the states of an editing session do. */
public final class DraftLevel {
    private DraftLevel() {}

    /** Returns the level after so many edits. */
    public static Level after(int edits) {
        return of(String.format(
                Locale.ROOT,
                "\"name\": \"draft\", \"solids\": [{\"id\": \"floor\", \"kind\": \"box\", \"centre\": [0, %d, 0],"
                        + " \"size\": [4, 1, 4]}]",
                edits));
    }

    /** Returns a level with these members. */
    public static Level of(String members) {
        String json = "{\"format\": \"nephele-level\", \"version\": 1, " + members + "}";
        return LevelJson.read("draft", json.getBytes(StandardCharsets.UTF_8));
    }
}
