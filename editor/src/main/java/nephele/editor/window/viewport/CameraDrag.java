package nephele.editor.window.viewport;

import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Button;
import nephele.editor.tool.Pointer.Modifier;
import nephele.engine.math.Vec3;

/**
 * Moves a camera by a drag of the right or the middle button.
 *
 * @param grabbed the point under the pointer when the button was pressed
 */
record CameraDrag(Way way, Vec3 grabbed, PaneSize size) {
    private static final double DEGREES_PER_POINT = 0.2;

    /** The kind of movement. */
    enum Way {
        LOOK,
        ORBIT,
        PAN
    }

    static CameraDrag of(Pointer pointer, Vec3 grabbed) {
        boolean pans = pointer.isPlan() || pointer.button() == Button.MIDDLE;
        Way way = pans ? Way.PAN : pointer.isHeld(Modifier.ALT) ? Way.ORBIT : Way.LOOK;
        return new CameraDrag(way, grabbed, pointer.size());
    }

    /** Returns the camera after a movement of the pointer by pixels to the right and down. */
    PaneCamera moved(PaneCamera camera, double across, double down, double pixelsPerPoint) {
        if (camera instanceof PlanCamera plan) {
            return PlanCamera.pan(plan, across, down);
        }
        PerspectiveCamera eye = (PerspectiveCamera) camera;
        double degrees = DEGREES_PER_POINT / pixelsPerPoint;
        return switch (way) {
            case LOOK -> PerspectiveCamera.look(eye, across, down, degrees);
            case ORBIT -> PerspectiveCamera.orbit(eye, grabbed, across * degrees * 2, down * degrees * 2);
            case PAN -> PerspectiveCamera.pan(eye, across, down, grabbed, size);
        };
    }
}
