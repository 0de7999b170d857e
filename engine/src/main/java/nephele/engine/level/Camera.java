package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * A fixed camera, or one that follows {@code path}, which has one entry for each frame.
 *
 * @param horizontalFovDegrees 0 if {@code verticalFovDegrees} is given; 90 if neither is
 * @param verticalFovDegrees 0 if {@code horizontalFovDegrees} is given
 */
public record Camera(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 position,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 target,
        @Written(absent = "[0, 1, 0]", spatial = Spatial.DIRECTION) @Range(min = 1e-9, shape = Range.Shape.DIRECTION)
                Vec3 up,
        @Written @Range(min = 1, max = 170) double horizontalFovDegrees,
        @Written @Range(min = 1, max = 170) double verticalFovDegrees,
        @Written(absent = "0.1") @Range(min = 1e-3) double nearMetres,
        @Written(absent = "10000") @Range(min = 1e-3) double farMetres,
        @Written(most = 100_000) List<Waypoint> path) {

    private static final double DEFAULT_HORIZONTAL_FOV_DEGREES = 90;

    public Camera {
        if (horizontalFovDegrees == 0 && verticalFovDegrees == 0) {
            horizontalFovDegrees = DEFAULT_HORIZONTAL_FOV_DEGREES;
        }
    }

    /** The eye and the look-at point of one frame. */
    public record Waypoint(
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 position,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 target) {}
}
