package nephele.editor.action;

import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.file.BackupList;
import nephele.editor.file.DroppedFile;
import nephele.editor.file.DroppedFile.Kind;
import nephele.editor.file.DroppedFile.SceneUse;
import nephele.editor.file.FileText;
import nephele.editor.record.EntityRef;
import nephele.editor.save.LevelPackage;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;

/** Packages, files that are added, backups, and work that a crash has left. */
final class ExchangeActions {
    private static final Words NO_FACE = Words.of(
            "there is no face '%s': write solid/side, such as wall/+y",
            "não há a face '%s': escreva sólido/lado, como wall/+y",
            "não há a face '%s': escreve sólido/lado, como wall/+y");

    private static final Words NO_USE = Words.of(
            "scene must be insert or replace, not '%s'",
            "scene deve ser insert ou replace, não '%s'", "scene deve ser insert ou replace, não '%s'");

    static final EditorAction EXPORT = EditorAction.of(
                    "export",
                    Words.of("Export with Assets…", "Exportar com os arquivos…", "Exportar com os ficheiros…"),
                    Menu.FILE,
                    List.of("Ctrl+Shift+E"),
                    ExchangeActions::export)
            .taking("file");

    static final EditorAction DROP = EditorAction.of(
                    "drop",
                    Words.of("Add a File…", "Adicionar um arquivo…", "Adicionar um ficheiro…"),
                    Menu.FILE,
                    List.of(),
                    ExchangeActions::drop)
            .taking("file", "at", "face", "scene");

    static final EditorAction BACKUPS = EditorAction.of(
                    "backups",
                    Words.of("Backups…", "Cópias de segurança…", "Cópias de segurança…"),
                    Menu.FILE,
                    List.of(),
                    ExchangeActions::backups)
            .taking("restore", "open")
            .changing(Subject.LEVEL)
            .when(session -> session.file().path().isPresent());

    static final EditorAction RECOVER = EditorAction.of(
                    "recover",
                    Words.of("Recover Lost Work…", "Recuperar trabalho perdido…", "Recuperar trabalho perdido…"),
                    Menu.FILE,
                    List.of(),
                    call -> call.ui().show("recover"))
            .changing(Subject.WINDOW);

    private ExchangeActions() {}

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
        if (use.isPresent() && (!isReplaced || FileActions.mayLeave(call))) {
            DroppedFile.Target target = new DroppedFile.Target(call.vector("at", Vec3.ZERO), face(call));
            new DroppedFile(call.session(), asked.get()).dropOn(target, use.get());
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
        } else if (FileActions.mayLeave(call)) {
            list.openCopy(number - 1);
        }
    }
}
