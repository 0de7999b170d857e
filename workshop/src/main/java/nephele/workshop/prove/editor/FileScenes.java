package nephele.workshop.prove.editor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import javax.swing.JComponent;
import nephele.editor.file.BackupList;
import nephele.editor.file.RecoveryList;
import nephele.editor.file.SessionJournal;
import nephele.editor.proving.PixelExplanation;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.session.EditorFiles;
import nephele.editor.session.EditorSession;
import nephele.editor.session.FileServices;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.window.WaitingLoop;
import nephele.editor.window.dialog.ExplanationPanel;
import nephele.editor.window.file.BackupsPanel;
import nephele.editor.window.file.RecoveryPanel;
import nephele.engine.level.Level;
import nephele.workshop.prove.process.TemporaryFolder;

/** The dialogues about files and pixels, whose content is made for them. */
final class FileScenes {
    private FileScenes() {}

    static List<EditorScene> all() {
        return List.of(
                new EditorScene("recovery", FileScenes::recovery),
                new EditorScene("backups", FileScenes::backups),
                new EditorScene("explanation", FileScenes::explanation));
    }

    private static EditorSession sessionIn(Path folder, DocumentFile.Opened opened, PicturedEditor editor) {
        var session = new EditorSession(
                opened.file(), opened.level(), opened.assets(), editor.look().settings());
        session.fileServices(FileServices.of(EditorFiles.of(null, folder)));
        session.background().runOn(new WaitingLoop(() -> {}));
        return session;
    }

    private static JComponent recovery(PicturedEditor editor) throws Exception {
        Path folder = Files.createTempDirectory("nephele-editor-pictures");
        try {
            Level level = editor.session().document().level();
            EditorSession lost = sessionIn(folder, DocumentFile.untitled(), editor);
            var journals = new JournalFolder(folder.resolve("journal"), Clock.systemUTC());
            var journal = new SessionJournal(lost, journals, words -> {});
            lost.document().edit(Words.of("Draw room", "Desenhar sala", "Desenhar sala"), before -> level);
            journal.leave();
            EditorSession next = sessionIn(folder, DocumentFile.untitled(), editor);
            try (var finder = new SessionJournal(
                    next, new JournalFolder(folder.resolve("journal"), Clock.systemUTC()), words -> {})) {
                var works = new RecoveryList(finder, finder.lost(), Instant.now(), ZoneOffset.UTC);
                return new RecoveryPanel(
                        works,
                        editor.look().language(),
                        new RecoveryPanel.Answers(question -> true, () -> true, () -> {}));
            }
        } finally {
            TemporaryFolder.delete(folder);
        }
    }

    private static JComponent backups(PicturedEditor editor) throws Exception {
        Path folder = Files.createTempDirectory("nephele-editor-pictures");
        try {
            return backups(editor, folder);
        } finally {
            TemporaryFolder.delete(folder);
        }
    }

    private static JComponent backups(PicturedEditor editor, Path folder) throws IOException, EditorRefusal {
        Path file = folder.resolve("room.json");
        EditorSession session = sessionIn(folder, DocumentFile.untitled(), editor);
        session.fileServices().saver().saveAs(file, editor.session().document().level());
        EditorSession opened =
                sessionIn(folder, session.background().get(() -> DocumentFile.open(file.toString())), editor);
        opened.fileServices().saver().saveAs(file, DocumentFile.untitled().level());
        return new BackupsPanel(
                new BackupList(opened, Instant.now(), ZoneOffset.UTC),
                editor.look().language(),
                new BackupsPanel.Answers(() -> true, words -> {}, () -> {}));
    }

    private static JComponent explanation(PicturedEditor editor) {
        var said = new PixelExplanation(List.of("solids/room-floor  +y", "lights/lamp: 0.42 W/m²"));
        return new ExplanationPanel(said, editor.look().language(), text -> {}, () -> {});
    }
}
