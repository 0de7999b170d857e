package nephele.editor.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import nephele.editor.document.Document;
import nephele.editor.document.Grid;
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.math.Vec3;

/** A session with a tool, and a pointer that goes to places in the world; one grid step is half a metre. */
public final class ToolScene {
    public static final PaneSize SIZE = new PaneSize(800, 600);
    private static final String CUBE =
            "{\"id\": \"cube\", \"kind\": \"box\", \"centre\": [0, 1, 0], \"size\": [2, 2, 2]}";

    private final EditorSession session;
    private final PaneKind kind;
    private final PaneCamera camera;

    private ToolScene(EditorSession session, PaneKind kind, PaneCamera camera) {
        this.session = session;
        this.kind = kind;
        this.camera = camera;
    }

    /** Returns a scene with a cube from (-1, 0, -1) to (1, 2, 1), seen from the front and above. */
    public static ToolScene withCube() {
        return of(CUBE);
    }

    /** Returns a scene with solids, written in JSON; the material {@code red} exists. */
    public static ToolScene of(String solids) {
        return of(solids, "");
    }

    /** Returns a scene with solids and further members of the level, each after a comma. */
    public static ToolScene of(String solids, String members) {
        String json =
                "{\"format\": \"nephele-level\", \"version\": 1, \"materials\": [{\"id\": \"red\"}], \"solids\": ["
                        + solids + "]" + members + "}";
        Level level = LevelJson.read("test.json", json.getBytes(StandardCharsets.UTF_8));
        return over(new EditorSession(DocumentFile.UNTITLED, level, NoFiles.AT_ALL, EditorSettings.DEFAULT));
    }

    /** Returns a scene of an open level. */
    public static ToolScene over(EditorSession session) {
        session.grid(new Grid(0.5));
        return new ToolScene(session, PaneKind.PERSPECTIVE, new PerspectiveCamera(new Vec3(3, 6, 10), 17, -28, 60));
    }

    /** Returns the same scene seen in a plan, with a pixel for each centimetre. */
    public ToolScene plan(PaneKind plan) {
        return new ToolScene(session, plan, new PlanCamera(plan, Vec3.ZERO, 0.01));
    }

    /** Returns this scene with a tool in use. */
    public ToolScene using(ToolEntry entry) {
        session.use(entry);
        return this;
    }

    /** Returns this scene with solids selected. */
    public ToolScene selecting(String... ids) {
        document()
                .select(Selection.of(List.of(ids).stream()
                        .map(id -> new EntityRef("solids", id))
                        .toList()));
        return this;
    }

    public EditorSession session() {
        return session;
    }

    public Document document() {
        return session.document();
    }

    public Tool tool() {
        return session.tool();
    }

    public Level level() {
        return document().level();
    }

    /** Returns a solid of what is shown. */
    public Solid solid(String id) {
        return level().solids().stream()
                .filter(solid -> solid.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    /** Asserts where a box of what is shown is. */
    public void assertBox(String id, Vec3 centre, Vec3 size) {
        Solid.Box box = (Solid.Box) solid(id);
        assertEquals(centre, box.centre());
        assertEquals(size, box.size());
    }

    /** Returns true if a solid of what is shown has vertices at these places, but for rounding. */
    public boolean hasVertices(String id, Vec3... places) {
        List<Vec3> vertices = Brush.of(solid(id)).shape().vertices();
        return List.of(places).stream().allMatch(place -> vertices.stream()
                .anyMatch(vertex -> vertex.minus(place).length() < 1e-9));
    }

    public double metresPerPixel(Vec3 at) {
        return camera.metresPerPixel(at, SIZE);
    }

    public void move(Vec3 to) {
        tool().moved(pointer(to));
    }

    public void press(Vec3 at, Modifier... held) {
        session.drag().press(pointer(at, held));
    }

    public void drag(Vec3 to, Modifier... held) {
        session.drag().move(pointer(to, held));
    }

    public void release(Vec3 at, Modifier... held) {
        session.drag().release(pointer(at, held));
    }

    /** Presses, drags and releases. */
    public void stroke(Vec3 from, Vec3 to, Modifier... held) {
        press(from, held);
        drag(to, held);
        release(to, held);
    }

    public void click(Vec3 at, Modifier... held) {
        press(at, held);
        release(at, held);
    }

    /** Clicks twice at one place. */
    public void doubleClick(Vec3 at) {
        click(at);
        Pointer once = pointer(at);
        Pointer twice = new Pointer(kind, camera, SIZE, once.x(), once.y(), Set.of(), 2);
        session.drag().press(twice);
        session.drag().release(twice);
    }

    /** Returns the pointer over a place. */
    public Pointer pointer(Vec3 at, Modifier... held) {
        PanePoint place = camera.project(at, SIZE).orElseThrow();
        return new Pointer(kind, camera, SIZE, place.x(), place.y(), Set.of(held), 1);
    }
}
