package nephele.editor.tool.terrain;

import java.util.Set;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PlanCamera;
import nephele.editor.session.EditorSession;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.math.Vec3;

/** A hand that drags in the plan from above, with a pixel for each 10 cm. */
record PlanHand(EditorSession session) {
    static Pointer at(double x, double z, Modifier... held) {
        return new Pointer(
                PaneKind.TOP,
                new PlanCamera(PaneKind.TOP, Vec3.ZERO, 0.1),
                new PaneSize(800, 600),
                400 + 10 * x,
                300 + 10 * z,
                Set.of(held),
                1);
    }

    void stroke(double fromX, double toX, Modifier... held) {
        session.drag().press(at(fromX, 0, held));
        session.drag().move(at(toX, 0, held));
        session.drag().release(at(toX, 0, held));
    }
}
