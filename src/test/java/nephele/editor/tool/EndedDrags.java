package nephele.editor.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import nephele.editor.document.Snapshot;
import nephele.editor.tool.select.SelectTool;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;

/** Checks that each end of a drag leaves what it must. */
public final class EndedDrags {
    private EndedDrags() {}

    /** Checks that Escape and another tool in the middle of a drag that shows a change restore the very same level. */
    public static void restore(ToolScene scene, Vec3 from, Vec3 to) {
        Snapshot before = scene.document().now();
        ToolEntry entry = scene.session().toolEntry();
        scene.press(from);
        scene.drag(to);
        assertNotSame(before.level(), scene.level(), "the drag shows nothing");
        scene.tool().cancel();
        assertUntouched(before, scene);
        scene.release(to);
        assertUntouched(before, scene);
        scene.press(from);
        scene.drag(to);
        scene.session().use(SelectTool.ENTRY);
        assertUntouched(before, scene);
        scene.session().use(entry);
    }

    private static void assertUntouched(Snapshot before, ToolScene scene) {
        assertSame(before.level(), scene.level());
        assertEquals(before.selection(), scene.document().selection());
        scene.document().undo();
        assertSame(before.level(), scene.level(), "a step was made");
    }

    /** Checks that the last change is one step after a level. */
    public static void assertOneStep(Level before, ToolScene scene) {
        assertNotSame(before, scene.level());
        scene.document().undo();
        assertSame(before, scene.level());
        scene.document().redo();
    }
}
