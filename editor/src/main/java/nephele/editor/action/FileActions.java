package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.file.FileText;
import nephele.editor.file.LevelOpening;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.DocumentFile.Outside;
import nephele.editor.save.DocumentSaver;
import nephele.editor.save.SaveResult;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;

/** Opening, saving, pictures and leaving. */
final class FileActions {
    private static final Words SAVED = Words.of("Saved %s", "%s foi salvo", "%s foi guardado");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of(
                    "new", Words.of("New", "Nova", "Novo"), Menu.FILE, List.of("Ctrl+N"), FileActions::newLevel),
            EditorAction.of(
                            "open",
                            Words.of("Open…", "Abrir…", "Abrir…"),
                            Menu.FILE,
                            List.of("Ctrl+O"),
                            FileActions::open)
                    .taking("file"),
            EditorAction.of(
                            "open-recent",
                            Words.of("Open Recent…", "Abrir recente…", "Abrir recente…"),
                            Menu.FILE,
                            List.of("Ctrl+Shift+O"),
                            call -> call.ui().show("open-recent"))
                    .changing(Subject.WINDOW),
            EditorAction.of(
                            "save",
                            Words.of("Save", "Salvar", "Guardar"),
                            Menu.FILE,
                            List.of("Ctrl+S"),
                            FileActions::save)
                    .taking("file"),
            EditorAction.of(
                            "save-as",
                            Words.of("Save As…", "Salvar como…", "Guardar como…"),
                            Menu.FILE,
                            List.of("Ctrl+Shift+S"),
                            FileActions::saveAs)
                    .taking("file"),
            ExchangeActions.EXPORT,
            ExchangeActions.DROP,
            ExchangeActions.BACKUPS,
            ExchangeActions.RECOVER,
            EditorAction.of(
                            "screenshot",
                            Words.of("Picture of the Editor…", "Imagem do editor…", "Imagem do editor…"),
                            Menu.FILE,
                            List.of("F12"),
                            FileActions::screenshot)
                    .taking("file"),
            EditorAction.of("quit", Words.of("Quit", "Sair", "Sair"), Menu.FILE, List.of("Ctrl+Q"), call -> call.ui()
                    .quit()));

    private FileActions() {}

    /** Returns true if the open level may be left: it has no changes, or the user agrees to lose them. */
    static boolean mayLeave(ActionCall call) {
        return !call.session().document().isModified() || call.ui().isAgreed(FileText.LOSES.words());
    }

    private static void newLevel(ActionCall call) {
        if (mayLeave(call)) {
            DocumentFile.Opened fresh = DocumentFile.untitled();
            call.session().open(fresh.file(), fresh.level(), fresh.assets());
        }
    }

    private static void open(ActionCall call) throws EditorRefusal {
        if (!mayLeave(call)) {
            return;
        }
        Optional<Path> asked = call.file(call.ui()::fileToOpen);
        if (asked.isEmpty()) {
            return;
        }
        LevelOpening.open(call.session(), asked.get().toString());
    }

    private static void save(ActionCall call) throws EditorRefusal {
        EditorSession session = call.session();
        if (call.text("file").isPresent()) {
            saveAs(call);
        } else if (session.file().path().isEmpty()) {
            saveAs(call);
        } else {
            Path path = session.file().path().get();
            DocumentSaver saver = session.fileServices().saver();
            Level level = session.document().level();
            SaveResult result = session.background()
                    .get(() -> session.hasMoved()
                            ? saver.save(session.file(), level, session.assets())
                            : saver.save(session.file(), level));
            if (result instanceof SaveResult.ChangedOutside changed) {
                // A deleted file holds nothing that could be lost.
                if (session.file().outside() != Outside.DELETED && !call.ui().isAgreed(changed.question())) {
                    return;
                }
                result = session.background().get(() -> saver.saveAs(path, level, session.assets()));
            }
            finish(call, result);
        }
    }

    private static void saveAs(ActionCall call) throws EditorRefusal {
        Optional<Path> asked = call.file(call.ui()::fileToSave);
        if (asked.isPresent()) {
            EditorSession session = call.session();
            Level level = session.document().level();
            DocumentSaver saver = session.fileServices().saver();
            finish(call, session.background().get(() -> saver.saveAs(asked.get(), level, session.assets())));
        }
    }

    /** Tells of the result; a user whose level was not saved may choose another place at once. */
    private static void finish(ActionCall call, SaveResult result) throws EditorRefusal {
        EditorSession session = call.session();
        if (result instanceof SaveResult.Failed failed) {
            Words reason = failed.message();
            if (!call.ui().isRemedied(reason, FileText.SAVE_AS.words())) {
                throw new EditorRefusal(reason);
            }
            session.status(reason);
            saveAs(new ActionCall(session, call.ui(), Map.of()));
        } else if (result instanceof SaveResult.Saved saved) {
            session.saved(saved.file());
            session.status(
                    saved.notices().isEmpty()
                            ? SAVED.with(saved.file().path().orElseThrow())
                            : saved.notices().get(0));
        }
    }

    private static void screenshot(ActionCall call) throws EditorRefusal {
        Optional<Path> asked = call.file(call.ui()::fileToSave);
        if (asked.isEmpty()) {
            return;
        }
        BufferedImage picture = call.ui().picture();
        try {
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageIO.write(picture, "png", png);
            AtomicFile.write(asked.get(), png.toByteArray());
        } catch (IOException problem) {
            throw new EditorRefusal(Words.same(problem.getMessage()));
        }
    }
}
