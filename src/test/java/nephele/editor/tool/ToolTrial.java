package nephele.editor.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import nephele.editor.document.Document;
import nephele.editor.document.Grid;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.text.Words;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.engine.rule.LevelRules;

/** A tool in use on a level, aimed at points of the world. */
public final class ToolTrial {
    /** A point of the floor of {@link nephele.engine.level.RoomLevel#hall}. */
    public static final Vec3 FLOOR = new Vec3(0, 0, -4);

    /** A point of the wall ahead there. */
    public static final Vec3 WALL = new Vec3(0, 2, -8);

    private static final PaneSize SIZE = new PaneSize(800, 600);

    private final List<String> messages = new ArrayList<>();
    private final ToolOptions options = new ToolOptions();
    private final Document document;
    private final Tool tool;
    private PaneKind kind = PaneKind.PERSPECTIVE;
    private PaneCamera camera = new PerspectiveCamera(new Vec3(0, 2, 6), 0, -10, 90);

    public ToolTrial(Level level, Function<ToolContext, Tool> make) {
        // A file says nothing of absent values, so only a level that was read can be equal to what is read back.
        document = new Document(read(level));
        tool = make.apply(new ToolContext(
                document, options, () -> new Grid(0.5), (Words words) -> messages.add(words.english())));
    }

    private static Level read(Level level) {
        return LevelJson.read("trial", LevelJson.write(level).getBytes(StandardCharsets.UTF_8));
    }

    public ToolTrial lookingFrom(Vec3 eye, double yawDegrees, double pitchDegrees) {
        kind = PaneKind.PERSPECTIVE;
        camera = new PerspectiveCamera(eye, yawDegrees, pitchDegrees, 90);
        return this;
    }

    public ToolTrial inPlan(PaneKind plan) {
        kind = plan;
        camera = new PlanCamera(plan, Vec3.ZERO, 0.02);
        return this;
    }

    public Document document() {
        return document;
    }

    public Level level() {
        return document.level();
    }

    public ToolOptions options() {
        return options;
    }

    public Tool tool() {
        return tool;
    }

    public List<String> messages() {
        return messages;
    }

    /** Returns the pointer over a point that the camera sees. */
    public Pointer over(Vec3 point, Modifier... held) {
        PanePoint at = camera.project(point, SIZE).orElseThrow();
        Set<Modifier> modifiers = EnumSet.noneOf(Modifier.class);
        modifiers.addAll(List.of(held));
        return new Pointer(kind, camera, SIZE, at.x(), at.y(), modifiers, 1);
    }

    public void click(Vec3 point, Modifier... held) {
        Pointer pointer = over(point, held);
        tool.moved(pointer);
        tool.pressed(pointer);
        tool.released(pointer);
    }

    public void press(Vec3 point, Modifier... held) {
        tool.moved(over(point, held));
        tool.pressed(over(point, held));
    }

    public void drag(Vec3 from, Vec3 to, Modifier... held) {
        press(from, held);
        tool.dragged(over(to, held));
        tool.released(over(to, held));
    }

    /** Asserts that an edit was made in one step, breaks no rule of the structure and survives the file. */
    public void assertOneSoundStep(Level before) {
        assertEquals(List.of(), LevelRules.checkRecords(level()));
        assertEquals(level(), read(level()));
        document.undo();
        assertSame(before, level());
        document.redo();
    }

    /** Asserts that Esc in the middle of a drag gives the same level back and that no step was made. */
    public void assertCancelledDrag(Vec3 from, Vec3 to) {
        Level before = level();
        press(from);
        tool.dragged(over(to));
        assertCancelled(before);
    }

    /** Asserts that Esc gives the same level back and that no step was made. */
    public void assertCancelled(Level before) {
        tool.cancel();
        assertSame(before, level());
        document.undo();
        assertSame(before, level());
    }
}
