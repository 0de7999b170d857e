package nephele.editor.session;

import java.time.Clock;
import nephele.editor.save.Backups;
import nephele.editor.save.DocumentSaver;
import nephele.editor.text.Words;
import nephele.host.userfile.UserFolders;

/**
 * The services that the files of a session need from its surroundings.
 *
 * @param backups of saved levels
 * @param saver writes levels, and keeps those backups
 * @param scenes imports XML scenes
 */
public record Filing(Backups backups, DocumentSaver saver, SceneImporter scenes) {
    private static final Words NO_SCENES = Words.of(
            "%s can't be imported here: use 'nephele import'",
            "%s não pode ser importado aqui: use 'nephele import'",
            "%s não pode ser importado aqui: usa 'nephele import'");

    /** Returns the folders of this user, without an importer. */
    public static Filing ofThisUser() {
        return of(EditorFiles.in(UserFolders.ofThisUser()));
    }

    /** Returns the folders of a user, without an importer. */
    public static Filing of(EditorFiles files) {
        Backups backups = new Backups(files.backups(), Clock.systemUTC());
        return new Filing(backups, new DocumentSaver(backups), (scene, level, complaints) -> {
            throw new FileRefusal(NO_SCENES.with(scene));
        });
    }

    public Filing with(SceneImporter importer) {
        return new Filing(backups, saver, importer);
    }
}
