package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.file.BackupList;
import nephele.editor.file.DroppedFile;
import nephele.editor.file.DroppedFile.Kind;
import nephele.editor.file.DroppedFile.SceneUse;
import nephele.editor.file.FileText;
import nephele.editor.file.LevelOpening;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.DocumentFile.Outside;
import nephele.editor.save.DocumentSaver;
import nephele.editor.save.LevelPackage;
import nephele.editor.save.SaveResult;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;

/** Opening, saving and leaving; packages, files that are added, backups, and pictures. */
final class FileActions {
    private static final Words SAVED = Words.of("Saved %s", "%s foi salvo", "%s foi guardado");

    private static final Words NO_FACE = Words.of(
            "there is no face '%s': write solid/side, such as wall/+y",
            "não há a face '%s': escreva sólido/lado, como wall/+y",
            "não há a face '%s': escreve sólido/lado, como wall/+y");

    private static final Words NO_USE = Words.of(
            "scene must be insert or replace, not '%s'",
            "scene deve ser insert ou replace, não '%s'", "scene deve ser insert ou replace, não '%s'");

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
            EditorAction.of(
                            "export",
                            Words.of("Export with Assets…", "Exportar com os arquivos…", "Exportar com os ficheiros…"),
                            Menu.FILE,
                            List.of("Ctrl+Shift+E"),
                            FileActions::export)
                    .taking("file"),
            EditorAction.of(
                            "drop",
                            Words.of("Add a File…", "Adicionar um arquivo…", "Adicionar um ficheiro…"),
                            Menu.FILE,
                            List.of(),
                            FileActions::drop)
                    .taking("file", "at", "face", "scene"),
            EditorAction.of(
                            "backups",
                            Words.of("Backups…", "Cópias de segurança…", "Cópias de segurança…"),
                            Menu.FILE,
                            List.of(),
                            FileActions::backups)
                    .taking("restore", "open")
                    .changing(Subject.LEVEL)
                    .when(session -> session.file().path().isPresent()),
            EditorAction.of(
                            "recover",
                            Words.of(
                                    "Recover Lost Work…", "Recuperar trabalho perdido…", "Recuperar trabalho perdido…"),
                            Menu.FILE,
                            List.of(),
                            call -> call.ui().show("recover"))
                    .changing(Subject.WINDOW),
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
    private static boolean mayLeave(ActionCall call) {
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

    private static void export(ActionCall call) throws EditorRefusal {
        Optional<Path> asked = call.file(call.ui()::fileToExport);
        if (asked.isEmpty()) {
            return;
        }
        EditorSession session = call.session();
        String name =
                session.file().path().map(path -> path.getFileName().toString()).orElse("level.json");
        Level level = session.document().level();
        session.background().get(() -> {
            LevelPackage.export(asked.get(), name, level, session.assets());
            return null;
        });
        session.status(FileText.EXPORTED.with(asked.get()));
    }

    private static void drop(ActionCall call) throws EditorRefusal {
        Optional<Path> asked = call.file(call.ui()::fileToAdd);
        if (asked.isEmpty()) {
            return;
        }
        Kind kind = Kind.of(asked.get());
        Optional<SceneUse> use = kind == Kind.SCENE ? sceneUse(call, asked.get()) : Optional.of(SceneUse.INSERT);
        boolean isReplaced = kind.replacesLevel() || use.equals(Optional.of(SceneUse.REPLACE));
        if (use.isPresent() && (!isReplaced || mayLeave(call))) {
            new DroppedFile(call.session(), asked.get()).dropOn(call.vector("at", Vec3.ZERO), face(call), use.get());
        }
    }

    private static Optional<SceneUse> sceneUse(ActionCall call, Path scene) throws EditorRefusal {
        Optional<String> typed = call.text("scene");
        if (typed.isEmpty()) {
            return DroppedFile.isUntouched(call.session())
                    ? Optional.of(SceneUse.REPLACE)
                    : call.ui().sceneUse(scene);
        }
        return Optional.of(
                switch (typed.get()) {
                    case "insert" -> SceneUse.INSERT;
                    case "replace" -> SceneUse.REPLACE;
                    default -> throw new EditorRefusal(NO_USE.with(typed.get()));
                });
    }

    /** Returns the face that is named, or the one that is selected. */
    private static Optional<FaceRef> face(ActionCall call) throws EditorRefusal {
        if (call.text("face").isEmpty()) {
            return call.session().document().selection().faces().stream().findFirst();
        }
        String typed = call.needed("face");
        int slash = typed.lastIndexOf('/');
        EntityRef solid = new EntityRef("solids", typed.substring(0, Math.max(0, slash)));
        String side = typed.substring(slash + 1);
        boolean isThere = call.session().document().level().solids().stream()
                .anyMatch(each ->
                        each.id().equals(solid.id()) && SolidFaces.names(each).contains(side));
        if (!isThere) {
            throw new EditorRefusal(NO_FACE.with(typed));
        }
        return Optional.of(new FaceRef(solid, side));
    }

    private static void backups(ActionCall call) throws EditorRefusal {
        boolean isRestore = call.text("restore").isPresent();
        if (!isRestore && !call.isGiven("open", "backups")) {
            return;
        }
        EditorSession session = call.session();
        BackupList list = new BackupList(session, Instant.now(), ZoneId.systemDefault());
        int number = call.whole(isRestore ? "restore" : "open", 0, Integer.MAX_VALUE, 1);
        if (number < 1 || number > list.rows().size()) {
            Path file = session.file().path().orElseThrow().getFileName();
            throw new EditorRefusal(
                    FileText.NO_BACKUP_NUMBER.with(number, file, list.rows().size()));
        }
        if (isRestore) {
            list.restore(number - 1);
        } else if (mayLeave(call)) {
            list.openCopy(number - 1);
        }
    }
}
