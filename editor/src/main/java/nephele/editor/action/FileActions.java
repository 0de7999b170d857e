package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.save.Backups;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.DocumentSaver;
import nephele.editor.save.SaveResult;
import nephele.editor.session.EditorSession;
import nephele.editor.session.NewDocument;
import nephele.editor.settings.EditorFiles;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.userfile.UserFolders;

/** Opening, saving, pictures and leaving. */
final class FileActions {
    private static final Words LOSES = Words.of(
            "The level has changes that are not saved. Go on without them?",
            "A fase tem mudanças que não foram salvas. Continuar sem elas?",
            "O nível tem alterações por guardar. Continuar sem elas?");
    private static final Words SAVED = Words.of("Saved %s", "%s foi salvo", "%s foi guardado");
    private static final Words NO_FILE = Words.of(
            "'%s' is no file name: choose another",
            "'%s' não é um nome de arquivo: escolha outro", "'%s' não é um nome de ficheiro: escolhe outro");

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
            EditorAction.of(
                            "screenshot",
                            Words.of("Picture of the Editor…", "Imagem do editor…", "Imagem do editor…"),
                            Menu.FILE,
                            List.of("F12"),
                            FileActions::screenshot)
                    .taking("file"),
            EditorAction.of("quit", Words.of("Quit", "Sair", "Sair"), Menu.FILE, List.of("Ctrl+Q"), call -> call.desk()
                    .quit()));

    private FileActions() {}

    private static boolean mayLeave(ActionCall call) {
        return !call.session().document().isModified() || call.desk().isAgreed(LOSES);
    }

    private static void newLevel(ActionCall call) {
        if (mayLeave(call)) {
            DocumentFile.Opened fresh = NewDocument.opened();
            call.session().open(fresh.file(), fresh.level(), fresh.assets());
        }
    }

    private static void open(ActionCall call) throws ActionFailure {
        if (!mayLeave(call)) {
            return;
        }
        Optional<Path> asked = call.text("file").isPresent()
                ? Optional.of(path(call))
                : call.desk().fileToOpen();
        if (asked.isEmpty()) {
            return;
        }
        try {
            DocumentFile.Opened opened = DocumentFile.open(asked.get().toString());
            call.session().open(opened.file(), opened.level(), opened.assets());
            opened.notice().ifPresent(notice -> call.session().status(Words.same(notice)));
        } catch (LevelFormatException problem) {
            throw new ActionFailure(Words.same(problem.getMessage()));
        }
    }

    private static Path path(ActionCall call) throws ActionFailure {
        String typed = call.needed("file");
        try {
            return Path.of(typed);
        } catch (InvalidPathException noPath) {
            throw new ActionFailure(NO_FILE.with(typed));
        }
    }

    private static void save(ActionCall call) throws ActionFailure {
        EditorSession session = call.session();
        if (call.text("file").isPresent()) {
            saveAs(call);
        } else if (session.file().path().isEmpty()) {
            saveAs(call);
        } else {
            SaveResult result = saver().save(session.file(), session.document().level());
            if (result instanceof SaveResult.ChangedOutside changed) {
                if (call.desk().isAgreed(changed.question())) {
                    finish(
                            session,
                            saver().saveAs(
                                            session.file().path().get(),
                                            session.document().level()));
                }
                return;
            }
            finish(session, result);
        }
    }

    private static void saveAs(ActionCall call) throws ActionFailure {
        Optional<Path> asked = call.text("file").isPresent()
                ? Optional.of(path(call))
                : call.desk().fileToSave();
        if (asked.isPresent()) {
            finish(
                    call.session(),
                    saver().saveAs(asked.get(), call.session().document().level()));
        }
    }

    private static DocumentSaver saver() {
        return new DocumentSaver(
                new Backups(EditorFiles.in(UserFolders.ofThisUser()).backups(), java.time.Clock.systemUTC()));
    }

    private static void finish(EditorSession session, SaveResult result) throws ActionFailure {
        if (result instanceof SaveResult.Failed failed) {
            throw new ActionFailure(failed.message());
        } else if (result instanceof SaveResult.Saved saved) {
            session.saved(saved.file());
            session.status(
                    saved.notices().isEmpty()
                            ? SAVED.with(saved.file().path().orElseThrow())
                            : saved.notices().get(0));
        }
    }

    private static void screenshot(ActionCall call) throws ActionFailure {
        Optional<Path> asked = call.text("file").isPresent()
                ? Optional.of(path(call))
                : call.desk().fileToSave();
        if (asked.isEmpty()) {
            return;
        }
        BufferedImage picture = call.desk().picture();
        try {
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageIO.write(picture, "png", png);
            AtomicFile.write(asked.get(), png.toByteArray());
        } catch (IOException problem) {
            throw new ActionFailure(Words.same(problem.getMessage()));
        }
    }
}
