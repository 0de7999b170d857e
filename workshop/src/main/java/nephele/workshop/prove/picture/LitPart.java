package nephele.workshop.prove.picture;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.ConvexPolyhedron.Face;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The lit part of a face, from the point of view of the light. Where it is narrower than a texel's diagonal it may fall
 * between the texels of the shadow map.
 *
 * @param brushes all that may cast shadows, and the face's own
 * @param place on the face
 * @param normal of the face
 * @param towardsLight of unit length
 * @param reachMetres distance within which a shadow caster counts
 */
record LitPart(List<Brush> brushes, Vec3 place, Vec3 normal, Vec3 towardsLight, double reachMetres) {
    private static final double TOUCH_METRES = 1e-6;
    private static final int DIRECTIONS = 24;
    private static final int STEPS = 12;

    /** Returns the lit part of the face at a place. */
    static LitPart at(List<Brush> brushes, Vec3 place, Vec3 towardsLight, double reachMetres) {
        Vec3 normal = brushes.stream()
                .filter(brush -> isWithin(brush, place))
                .flatMap(brush -> brush.shape().faces().stream())
                .filter(face -> Math.abs(face.plane().signedDistance(place)) < TOUCH_METRES)
                .map(face -> face.plane().normal())
                .filter(n -> n.dot(towardsLight) > 0)
                .findFirst()
                .orElse(towardsLight);
        return new LitPart(brushes, place, normal, towardsLight, reachMetres);
    }

    /**
     * Returns true if a line across the lit part, through the place, is shorter than {@code metres}; false if the place
     * is not lit.
     */
    boolean isNarrowerThan(double metres) {
        if (!isLit(place)) {
            return false;
        }
        Vec3 across = Directions.perpendicular(towardsLight);
        Vec3 up = towardsLight.cross(across);
        for (int i = 0; i < DIRECTIONS; i++) {
            double x = StrictMath.cos(Math.PI * i / DIRECTIONS);
            double y = StrictMath.sin(Math.PI * i / DIRECTIONS);
            Vec3 direction = onFace(Directions.combined(across, x, up, y));
            if (litMetres(direction, metres) + litMetres(Directions.combined(direction, -1, direction, 0), metres)
                    < metres) {
                return true;
            }
        }
        return false;
    }

    /** Returns the step on the face that appears, from the light, as the given step across its rays. */
    private Vec3 onFace(Vec3 step) {
        return Directions.combined(step, 1, towardsLight, -normal.dot(step) / normal.dot(towardsLight));
    }

    private double litMetres(Vec3 direction, double most) {
        for (int i = 1; i <= STEPS; i++) {
            if (!isLit(Directions.combined(place, 1, direction, most * i / STEPS))) {
                return most * (i - 1) / STEPS;
            }
        }
        return most;
    }

    /** Returns true if a point of the face's plane is on some solid and no solid shades it. */
    private boolean isLit(Vec3 point) {
        return brushes.stream().anyMatch(brush -> isWithin(brush, point))
                && brushes.stream().noneMatch(brush -> shades(brush, point));
    }

    private boolean shades(Brush brush, Vec3 point) {
        double enter = TOUCH_METRES;
        double leave = reachMetres;
        for (Face face : brush.shape().faces()) {
            double distance = face.plane().signedDistance(point);
            double speed = face.plane().normal().dot(towardsLight);
            if (speed < 0) {
                enter = Math.max(enter, -distance / speed);
            } else if (speed > 0) {
                leave = Math.min(leave, -distance / speed);
            } else if (distance > 0) {
                return false;
            }
        }
        return leave - enter > TOUCH_METRES;
    }

    private static boolean isWithin(Brush brush, Vec3 point) {
        return brush.shape().faces().stream().allMatch(face -> face.plane().signedDistance(point) < TOUCH_METRES);
    }
}
