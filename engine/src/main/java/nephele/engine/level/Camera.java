package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * A fixed camera, or one that follows {@code path} with one entry a frame.
 *
 * @param horizontalFovDegrees 0 when {@code verticalFovDegrees} is given instead
 * @param verticalFovDegrees 0 when {@code horizontalFovDegrees} is given
 */
public record Camera(
        String id,
        Vec3 position,
        Vec3 target,
        Vec3 up,
        double horizontalFovDegrees,
        double verticalFovDegrees,
        double nearMetres,
        double farMetres,
        List<Waypoint> path) {

    /** Eye and look-at point of one frame. */
    public record Waypoint(Vec3 position, Vec3 target) {}
}
