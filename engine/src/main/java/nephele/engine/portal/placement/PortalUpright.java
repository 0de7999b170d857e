package nephele.engine.portal.placement;

import java.util.function.UnaryOperator;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The up direction of a portal. On a wall it is up along the wall: (D × N) × N for D = (0, 1, 0), oriented up. On
 * floors and ceilings it is the direction that the shooter faces, without its component along the normal. Between the
 * two, it rotates with the slope by the shorter way, so that it is continuous while a surface tilts.
 */
final class PortalUpright {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** |N.y| up to which a surface counts as a wall: slopes steeper than 30°. */
    private static final double WALL = 0.8660254037844386;

    /** |N.y| from which a surface counts as floor or ceiling: 10° off level. */
    private static final double LEVEL = 0.984807753012208;

    /** Angle in radians from opposite directions within which rounding would decide the sense of rotation. */
    private static final double OPPOSITE = 1e-6;

    private PortalUpright() {}

    /**
     * Returns the up direction.
     *
     * @return of unit length and perpendicular to the unit {@code normal}
     */
    static Vec3 on(Vec3 normal, Basis view) {
        return on(normal, view, UnaryOperator.identity());
    }

    /**
     * Returns the up direction where the direction ahead on floors and ceilings is turned first.
     *
     * @param turn maps a unit direction along the surface to another one
     */
    static Vec3 on(Vec3 normal, Basis view, UnaryOperator<Vec3> turn) {
        double level = level(normal);
        if (level == 0) {
            return alongSurface(UP, normal);
        }
        Vec3 ahead = turn.apply(alongSurface(ahead(view), normal));
        if (level == 1) {
            return ahead;
        }
        return turned(alongSurface(UP, normal), ahead, normal, level);
    }

    /** Returns true for surfaces on which the up direction depends on the shooter's view. */
    static boolean followsView(Vec3 normal) {
        return level(normal) > 0;
    }

    /** Returns 0 for walls, 1 for floors and ceilings, and smooth values between. */
    private static double level(Vec3 normal) {
        double steepness = Math.abs(normal.y());
        double t = Math.max(0, Math.min(1, (steepness - WALL) / (LEVEL - WALL)));
        return t * t * (3 - 2 * t);
    }

    /**
     * Returns the horizontal direction that the shooter faces. Without roll it is the view's own; straight down, where
     * the view has none, the right axis gives it.
     */
    private static Vec3 ahead(Basis view) {
        double x = -view.back().x();
        double z = -view.back().z();
        double steep = 1 - Math.sqrt(x * x + z * z);
        // D × right, which has no upward component.
        Vec3 ahead = Directions.unit(
                x + steep * view.right().z(), 0, z - steep * view.right().x());
        return ahead == null ? new Vec3(0, 0, -1) : ahead;
    }

    private static Vec3 alongSurface(Vec3 direction, Vec3 normal) {
        double off = direction.dot(normal);
        return Directions.unit(direction.addScaled(-off, normal));
    }

    /**
     * Rotates {@code from} towards {@code to}; exactly opposite directions rotate counter-clockwise as seen from in
     * front.
     */
    private static Vec3 turned(Vec3 from, Vec3 to, Vec3 normal, double fraction) {
        Vec3 left = normal.cross(from);
        double angle = StrictMath.atan2(to.dot(left), to.dot(from));
        double turn = fraction * (angle < OPPOSITE - Math.PI ? Math.PI : angle);
        double cos = StrictMath.cos(turn);
        double sin = StrictMath.sin(turn);
        return alongSurface(Directions.combined(from, cos, left, sin), normal);
    }
}
