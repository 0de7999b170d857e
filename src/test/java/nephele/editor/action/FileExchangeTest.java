package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import nephele.editor.file.FiledSession;
import nephele.editor.save.DraftLevel;
import nephele.editor.session.EditorSession;
import nephele.editor.session.FileServices;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Files that come into a level and leave it, by lines of a script. */
@Execution(ExecutionMode.CONCURRENT)
class FileExchangeTest {
    private static final String TRIANGLE =
            """
            {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
              "min": [0, 0, 0], "max": [1, 1, 0]}],
             "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "tri.bin", "byteLength": 36}]}
            """;

    @TempDir
    Path folder;

    private Path elsewhere;
    private Path file;
    private EditorSession session;
    private ScriptRunner script;

    @BeforeEach
    void open() throws IOException {
        elsewhere = Files.createDirectory(folder.resolve("else where"));
        Path levels = Files.createDirectory(folder.resolve("mine"));
        file = levels.resolve("room.json");
        use(FiledSession.of(folder, file, DraftLevel.after(0)));
    }

    private void use(EditorSession other) {
        session = other;
        script = new ScriptRunner(session, new ScriptInterface(() -> new BufferedImage(4, 4, 1)));
    }

    private void run(String line) throws EditorRefusal {
        script.run(line);
    }

    private String refused(String line) {
        Level before = session.document().level();
        String said = assertThrows(EditorRefusal.class, () -> run(line)).getMessage();
        assertEquals(before, session.document().level());
        return said;
    }

    private Path picture(String name) throws IOException {
        Path picture = elsewhere.resolve(name);
        ImageIO.write(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), "png", picture.toFile());
        return picture;
    }

    private List<String> filesBeside() throws IOException {
        Path beside = file.getParent();
        try (Stream<Path> all = Files.walk(beside)) {
            return all.filter(Files::isRegularFile)
                    .map(each -> beside.relativize(each).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    private static String drop(Path dropped) {
        return "drop file=\"" + dropped + "\"";
    }

    @Test
    void aPictureBecomesATextureAndTheMaterialOfTheFace() throws Exception {
        run(drop(picture("Old Wall!.png")) + " face=floor/+y");
        assertEquals(List.of("room.json", "textures/Old-Wall.png"), filesBeside());
        assertEquals(
                "textures/Old-Wall.png",
                session.document().level().materials().get(0).texture());
        Solid floor = session.document().level().solids().get(0);
        assertEquals("Old-Wall", SolidFaces.authored(floor, "+y").material());
        assertEquals("Old-Wall", session.options().material());
        assertTrue(session.assets().exists("textures/Old-Wall.png"));
        run("undo");
        assertEquals(DraftLevel.after(0), session.document().level());
        run("redo");
        run(drop(elsewhere.resolve("Old Wall!.png")));
        assertEquals(1, session.document().level().materials().size(), "the same picture is the same material");
        Files.write(elsewhere.resolve("Old Wall!.png"), png(3));
        run(drop(elsewhere.resolve("Old Wall!.png")));
        assertEquals(List.of("room.json", "textures/Old-Wall-2.png", "textures/Old-Wall.png"), filesBeside());
        run(drop(file.resolveSibling("textures/Old-Wall.png")));
        assertEquals(3, filesBeside().size(), "an asset of the level is not copied");
    }

    private static byte[] png(int side) throws IOException {
        var bytes = new java.io.ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB), "png", bytes);
        return bytes.toByteArray();
    }

    @Test
    void aModelComesWithTheFilesThatItNames() throws Exception {
        Path model = elsewhere.resolve("tri.gltf");
        Files.writeString(model, TRIANGLE);
        String missing = refused(drop(model));
        assertTrue(missing.contains("tri.bin"), missing);
        assertEquals(List.of("room.json"), filesBeside());
        ByteBuffer corners = ByteBuffer.allocate(36).order(ByteOrder.LITTLE_ENDIAN);
        for (float each : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
            corners.putFloat(each);
        }
        Files.write(elsewhere.resolve("tri.bin"), corners.array());
        run(drop(model) + " at=1,2,3");
        assertEquals(List.of("models/tri.bin", "models/tri.gltf", "room.json"), filesBeside());
        var placed = session.document().level().models().get(0);
        assertEquals("models/tri.gltf", placed.file());
        assertEquals(
                List.of(new nephele.engine.level.ModelPlacement.TransformStep.Translate(new Vec3(1, 2, 3))),
                placed.transform());
    }

    @Test
    void aGridOfDensitiesBecomesACloud() throws Exception {
        Path grid = elsewhere.resolve("puff.vol");
        ByteBuffer bytes = ByteBuffer.allocate(48 + 8 * 4).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put("VOL".getBytes(StandardCharsets.US_ASCII)).put((byte) 3);
        bytes.putInt(1).putInt(2).putInt(2).putInt(2).putInt(1);
        bytes.putFloat(-5).putFloat(0).putFloat(-5).putFloat(5).putFloat(4).putFloat(5);
        Files.write(grid, bytes.array());
        run(drop(grid) + " at=0,60,0");
        Cloud cloud = session.document().level().environment().clouds().get(0);
        assertEquals(new Cloud.Extent.Volume(new Vec3(0, 62, 0), new Vec3(10, 4, 10)), cloud.extent());
        assertEquals(new Cloud.Density.Grid("clouds/puff.vol"), cloud.density());
        run("save");
        assertEquals(session.document().level(), LevelFile.read(file));
        Files.write(grid, "VOL\3 but no more".getBytes(StandardCharsets.US_ASCII));
        assertTrue(refused(drop(grid)).contains("no Mitsuba .vol file"));
    }

    @Test
    void rawHeightsBecomeATerrain() throws Exception {
        Path heights = Files.write(elsewhere.resolve("hills.r16"), new byte[2 * 33 * 33]);
        run(drop(heights) + " at=0,5,0");
        assertEquals(
                "terrain/hills.r16",
                session.document().level().terrains().get(0).heightMap());
        Files.write(heights, new byte[7]);
        assertTrue(refused(drop(heights)).contains("hills.r16 can't be used"));
    }

    @Test
    void aSceneJoinsTheOpenLevelUnlessItIsToReplaceIt() throws Exception {
        session.fileServices(
                session.fileServices().with((scene, level, complaints) -> LevelFile.save(level, DraftLevel.after(5))));
        Path scene = elsewhere.resolve("room.xml");
        Files.writeString(scene, "<scene/>");
        Level before = session.document().level();
        run(drop(scene) + " at=0,9,0");
        assertEquals(file, session.file().path().orElseThrow(), "the level stays open");
        assertEquals(
                before.solids().size() + DraftLevel.after(5).solids().size(),
                session.document().level().solids().size());
        assertEquals(List.of("room.json"), filesBeside());
        run("undo");
        assertEquals(before, session.document().level());
        assertTrue(refused(drop(scene) + " scene=both").contains("insert or replace"));
        use(FiledSession.untitled(folder));
        run("brush box min=0,0,0 max=1,1,1");
        assertTrue(refused(drop(scene)).contains("Save the level first"));
    }

    @Test
    void aSceneIsImportedBesideTheLevelAndOpened() throws Exception {
        session.fileServices(session.fileServices().with((scene, level, complaints) -> {
            LevelFile.save(level, DraftLevel.after(5));
            complaints.accept(scene + ":3: a light was left out");
        }));
        Path scene = elsewhere.resolve("room.xml");
        Files.writeString(scene, "<scene/>");
        run(drop(scene) + " scene=replace");
        assertEquals(DraftLevel.after(5), session.document().level());
        assertEquals(file.resolveSibling("room-2.json"), session.file().path().orElseThrow(), "room.json is there");
        assertTrue(session.status().english().endsWith(":3: a light was left out"));
        session.fileServices(session.fileServices().with((bad, level, complaints) -> {
            throw new EditorRefusal(Words.same("no scene"));
        }));
        assertEquals("no scene", refused(drop(scene)));
    }

    @Test
    void whatCannotBeUsedIsRefusedAndLeavesNothing() throws Exception {
        Path text = elsewhere.resolve("notes.txt");
        Files.writeString(text, "x");
        assertTrue(refused(drop(text)).contains("notes.txt can't be used: drop pictures"));
        assertTrue(refused(drop(elsewhere)).contains("drop pictures"));
        Path fake = elsewhere.resolve("fake.png");
        Files.writeString(fake, "no picture");
        assertTrue(refused(drop(fake)).contains("fake.png can't be used"));
        assertTrue(refused(drop(elsewhere.resolve("none.png"))).contains("none.png can't be used"));
        Files.writeString(elsewhere.resolve("bad.obj"), "f 1 2 3\n");
        assertTrue(refused(drop(elsewhere.resolve("bad.obj"))).contains("bad.obj"));
        assertTrue(refused(drop(picture("a.png")) + " face=floor/up").contains("there is no face 'floor/up'"));
        assertEquals(List.of("room.json"), filesBeside());
        use(FiledSession.untitled(folder));
        assertTrue(refused(drop(picture("a.png"))).contains("Save the level first"));
    }

    @Test
    void aPackageTakesTheLevelElsewhereWithItsFiles() throws Exception {
        run(drop(picture("wall.png")));
        Path zip = elsewhere.resolve("my room.zip");
        run("export file=\"" + zip + "\"");
        Level exported = session.document().level();
        use(FiledSession.untitled(folder));
        run("open file=\"" + zip + "\"");
        assertEquals(exported, session.document().level());
        Path unpacked = elsewhere.resolve("my room").resolve("room.json");
        assertEquals(unpacked, session.file().path().orElseThrow());
        assertArrayEquals(
                Files.readAllBytes(elsewhere.resolve("wall.png")),
                session.assets().bytes("textures/wall.png"));
        run(drop(zip));
        assertEquals(
                elsewhere.resolve("my room-2").resolve("room.json"),
                session.file().path().orElseThrow());
        Files.writeString(zip, "no zip");
        assertTrue(refused("open file=\"" + zip + "\"").contains("Choose a .zip that the editor exported"));
        assertTrue(refused("export file=/no/such/a.zip").contains("is missing: nothing was saved"));
        Files.delete(elsewhere.resolve("my room-2").resolve("textures").resolve("wall.png"));
        String missing = refused("export file=\"" + elsewhere.resolve("b.zip") + "\"");
        assertTrue(missing.contains("textures/wall.png"), missing);
        assertFalse(Files.exists(elsewhere.resolve("b.zip")));
    }

    @Test
    void backupsAreRestoredAndOpened() throws Exception {
        for (int i = 1; i <= 2; i++) {
            FiledSession.edit(session, DraftLevel.after(i));
            run("save");
        }
        run("backups restore=1");
        assertEquals(DraftLevel.after(1), session.document().level());
        assertTrue(session.document().isModified());
        run("undo");
        assertEquals(DraftLevel.after(2), session.document().level());
        String said = refused("backups restore=3");
        assertEquals("there is no backup 3: room.json has 2", said);
        run("backups open=2");
        assertEquals(DraftLevel.after(0), session.document().level());
        assertTrue(session.file().path().isEmpty());
        assertEquals(DraftLevel.after(2), LevelFile.read(file));
    }

    /** The ui of a user who saves elsewhere, once. */
    private static final class Remedy implements UserInterface {
        private final List<String> told = new ArrayList<>();
        private final Path instead;

        Remedy(Path instead) {
            this.instead = instead;
        }

        @Override
        public boolean isRemedied(Words problem, Words remedy) {
            told.add(problem.english() + "|" + remedy.english());
            return told.size() < 2;
        }

        @Override
        public java.util.Optional<Path> fileToOpen() {
            return java.util.Optional.empty();
        }

        @Override
        public java.util.Optional<Path> fileToSave() {
            return java.util.Optional.of(instead);
        }

        @Override
        public boolean isAgreed(Words question) {
            return true;
        }

        @Override
        public BufferedImage picture() {
            return null;
        }

        @Override
        public void copy(String text) {
            throw new AssertionError(text);
        }

        @Override
        public String pasted() {
            return "";
        }

        @Override
        public void show(String part) {
            throw new AssertionError(part);
        }

        @Override
        public void quit() {
            throw new AssertionError();
        }
    }

    private Remedy savedWith(Path instead) throws EditorRefusal {
        Remedy ui = new Remedy(instead);
        FiledSession.edit(session, DraftLevel.after(1));
        new ScriptRunner(session, ui).run("save");
        return ui;
    }

    @Test
    void aReadOnlyFileIsToldAndTheLevelSavedElsewhere() throws Exception {
        assertTrue(file.toFile().setReadOnly());
        Path instead = elsewhere.resolve("b.json");
        Remedy ui = savedWith(instead);
        assertEquals(1, ui.told.size());
        assertTrue(ui.told.get(0).contains("room.json is read-only: nothing was saved."), ui.told.get(0));
        assertTrue(ui.told.get(0).endsWith("|Save As…"));
        assertEquals(DraftLevel.after(1), LevelFile.read(instead));
        assertEquals(DraftLevel.after(0), LevelFile.read(file));
        assertFalse(session.document().isModified());
    }

    @Test
    void aDeletedFolderIsToldAndWorkIsKeptIfTheUserDeclines() throws Exception {
        Files.delete(file);
        Files.delete(file.getParent());
        Path nowhere = folder.resolve("none").resolve("b.json");
        EditorRefusal failure = assertThrows(EditorRefusal.class, () -> savedWith(nowhere));
        assertTrue(failure.getMessage().contains("The folder " + nowhere.getParent() + " is missing"));
        assertEquals(DraftLevel.after(1), session.document().level());
        assertTrue(session.document().isModified());
    }

    @Test
    void aFullDiskIsToldAndTheLevelSavedElsewhere() throws Exception {
        FullDisk disk = new FullDisk(file.getParent());
        FileServices real = session.fileServices();
        session.fileServices(new FileServices(
                real.backups(), new nephele.editor.save.DocumentSaver(real.backups(), disk), real.scenes()));
        Path instead = elsewhere.resolve("b.json");
        Remedy ui = savedWith(instead);
        assertTrue(ui.told.get(0).startsWith("The disk of " + file + " is full: nothing was saved."));
        assertEquals(DraftLevel.after(1), LevelFile.read(instead));
        assertEquals(DraftLevel.after(0), LevelFile.read(file));
    }
}
