package nephele.editor.pane;

import java.util.Optional;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** The camera of a pane: an immutable value. Pixels count from the upper left corner of the pane, x right, y down. */
public sealed interface PaneCamera permits PerspectiveCamera, PlanCamera {
    /** Returns the ray of sight through a place in the picture; its direction has unit length. */
    Ray ray(double x, double y, PaneSize size);

    /** Returns where a point appears, also outside the picture; empty if it is not in front of the camera. */
    Optional<PanePoint> project(Vec3 point, PaneSize size);

    /** Returns the length in the world that one pixel shows at the distance of a point. */
    double metresPerPixel(Vec3 at, PaneSize size);

    /** Returns the unit direction to the right in the picture. */
    Vec3 right();

    /** Returns the unit direction upwards in the picture. */
    Vec3 up();

    /** Returns the unit direction of sight through the middle of the picture. */
    Vec3 forward();

    /** The size of a pane in pixels; both sides are at least 1. */
    record PaneSize(int width, int height) {
        public PaneSize {
            width = Math.max(1, width);
            height = Math.max(1, height);
        }

        public double aspect() {
            return width / (double) height;
        }
    }

    /**
     * A place in the picture.
     *
     * @param depthMetres distance along the direction of sight
     */
    record PanePoint(double x, double y, double depthMetres) {}
}
