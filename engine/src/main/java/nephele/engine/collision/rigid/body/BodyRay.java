package nephele.engine.collision.rigid.body;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Intersection of a ray with a body. Reused for every query; allocates nothing. */
public final class BodyRay {
    private final BodyTable table;
    private final Vector3d origin = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private final Vector3d centre = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    public BodyRay(BodyTable table) {
        this.table = table;
    }

    /**
     * Returns the ray parameter at which the body is entered, 0 for a ray that starts in it, infinity for a miss:
     * metres for a direction of unit length.
     */
    public double distance(Bodies bodies, int body, Vector3dc from, Vector3dc way) {
        bodies.orientation(body, turn);
        bodies.centre(body, centre);
        turn.transformInverse(from.sub(centre, origin));
        turn.transformInverse(way, direction);
        return switch (table.kind(body)) {
            case BodyTable.SPHERE -> ball(0, table.half(body, 2));
            case BodyTable.CAPSULE -> capsule(table.half(body, 1), table.half(body, 2));
            default -> box(body);
        };
    }

    /** Intersects the slabs of three pairs of planes (Kay and Kajiya 1986). */
    private double box(int body) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double half = table.half(body, axis);
            double rate = direction.get(axis);
            double at = origin.get(axis);
            if (rate == 0) {
                leave = Math.abs(at) > half ? Double.NEGATIVE_INFINITY : leave;
            } else {
                enter = Math.max(enter, (-Math.copySign(half, rate) - at) / rate);
                leave = Math.min(leave, (Math.copySign(half, rate) - at) / rate);
            }
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    /** Intersects a sphere with its centre {@code height} above the body's. */
    private double ball(double height, double radius) {
        double y = origin.y - height;
        double offset = origin.x * origin.x + y * y + origin.z * origin.z - radius * radius;
        double along = origin.x * direction.x + y * direction.y + origin.z * direction.z;
        return entry(direction.lengthSquared(), along, offset);
    }

    /** Intersects two spheres and the tube between them. */
    private double capsule(double halfAxis, double radius) {
        double square = direction.x * direction.x + direction.z * direction.z;
        double along = origin.x * direction.x + origin.z * direction.z;
        double offset = origin.x * origin.x + origin.z * origin.z - radius * radius;
        double tube = square > 0 ? entry(square, along, offset) : offset <= 0 ? 0 : Double.POSITIVE_INFINITY;
        boolean between = Math.abs(origin.y + tube * direction.y) <= halfAxis;
        return Math.min(
                between ? tube : Double.POSITIVE_INFINITY, Math.min(ball(-halfAxis, radius), ball(halfAxis, radius)));
    }

    /** Returns the first t ≥ 0 with square t² + 2 along t + offset ≤ 0, infinity for none. */
    private static double entry(double square, double along, double offset) {
        if (offset <= 0) {
            return 0;
        }
        double root = Math.sqrt(along * along - square * offset);
        return along < 0 && root >= 0 ? offset / (root - along) : Double.POSITIVE_INFINITY;
    }
}
