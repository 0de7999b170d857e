package nephele.editor.action;

import java.nio.file.Path;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.text.EditorRefusal;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;

/** A session of tests that runs script lines. */
public record ScriptedSession(EditorSession session, ScriptRunner script) {
    /** Returns a session of an empty level. */
    public static ScriptedSession empty() {
        return of(DocumentFile.untitled().level());
    }

    public static ScriptedSession of(Level level) {
        EditorSession session = new EditorSession(
                DocumentFile.UNTITLED,
                level,
                LevelAssets.beside(Path.of("levels", "untitled.json")),
                EditorSettings.DEFAULT);
        return new ScriptedSession(
                session,
                new ScriptRunner(session, new ScriptInterface(() -> new java.awt.image.BufferedImage(4, 4, 1))));
    }

    /** Runs lines that must succeed. */
    public ScriptedSession run(String... lines) {
        for (String line : lines) {
            try {
                script.run(line);
            } catch (EditorRefusal problem) {
                throw new AssertionError(line + ": " + problem.getMessage(), problem);
            }
        }
        return this;
    }

    public Level level() {
        return session.document().level();
    }

    /** Returns the text of the level. */
    public String json() {
        return LevelJson.write(level());
    }
}
