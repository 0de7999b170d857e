package nephele.editor.file;

import java.nio.file.Path;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.FileServices;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;

/** Sessions of tests whose backups lie in a folder of the test. */
public final class FiledSession {
    private FiledSession() {}

    /** Returns the folders of the editor's own files below a test's folder. */
    public static EditorFiles files(Path folder) {
        return EditorFiles.of(null, folder);
    }

    /** Returns a session of an untitled level. */
    public static EditorSession untitled(Path folder) {
        DocumentFile.Opened opened = DocumentFile.untitled();
        EditorSession session =
                new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
        session.fileServices(FileServices.of(files(folder)));
        return session;
    }

    /** Returns a session of a level that is saved to a file first. */
    public static EditorSession of(Path folder, Path file, Level level) {
        LevelFile.save(file, level);
        DocumentFile.Opened opened = DocumentFile.open(file.toString());
        EditorSession session =
                new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
        session.fileServices(FileServices.of(files(folder)));
        return session;
    }

    /** Replaces the level as an edit does. */
    public static void edit(EditorSession session, Level level) {
        session.document().edit(Words.same("edit"), before -> level);
    }
}
