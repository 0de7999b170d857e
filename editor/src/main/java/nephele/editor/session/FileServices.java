package nephele.editor.session;

import java.nio.file.Path;
import java.time.Clock;
import java.util.function.Consumer;
import nephele.editor.save.Backups;
import nephele.editor.save.DocumentSaver;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.host.userfile.UserFolders;

/**
 * The services that the files of a session need from its surroundings.
 *
 * @param backups of saved levels
 * @param saver writes levels, and keeps those backups
 * @param scenes imports XML scenes
 */
public record FileServices(Backups backups, DocumentSaver saver, SceneImporter scenes) {
    private static final Words NO_SCENES = Words.of(
            "%s can't be imported here: use 'nephele import'",
            "%s não pode ser importado aqui: use 'nephele import'",
            "%s não pode ser importado aqui: usa 'nephele import'");

    /** Returns the folders of this user, without an importer. */
    public static FileServices ofThisUser() {
        return of(EditorFiles.in(UserFolders.ofThisUser()));
    }

    /** Returns the folders of a user, without an importer. */
    public static FileServices of(EditorFiles files) {
        Backups backups = new Backups(files.backups(), Clock.systemUTC());
        return new FileServices(backups, new DocumentSaver(backups), (scene, level, complaints) -> {
            throw new EditorRefusal(NO_SCENES.with(scene));
        });
    }

    public FileServices with(SceneImporter importer) {
        return new FileServices(backups, saver, importer);
    }

    /** Converts XML scenes to levels. */
    @FunctionalInterface
    public interface SceneImporter {
        /**
         * Writes the level of a scene with its meshes and pictures beside it, or nothing at all after a failure.
         *
         * @param complaints receives a line for each thing that a level can't hold
         * @throws EditorRefusal if the scene can't be read or makes no level
         */
        void save(Path scene, Path level, Consumer<String> complaints) throws EditorRefusal;
    }
}
