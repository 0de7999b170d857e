package nephele.engine.scene.dynamic;

import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

/**
 * The exact shape of one rigid part: half sides of a box about the part's origin, the radius of a sphere, or radius and
 * half the axis of a capsule along y.
 *
 * @param kind one of the constants; shaders read it
 * @param half scale of the unit mesh, metres
 * @param halfAxisMetres half the distance between the centres of a capsule's round ends, otherwise 0
 */
public record DynamicShape(int kind, Vec3 half, double halfAxisMetres) {
    public static final int BOX = 0;
    public static final int SPHERE = 1;
    public static final int CAPSULE = 2;
    /** A mesh of its own that is not scaled; {@code half} bounds it. */
    public static final int PART = 3;

    static DynamicShape of(Body body) {
        if (body instanceof Body.Box box) {
            Vec3 size = box.size();
            return new DynamicShape(BOX, new Vec3(size.x() / 2, size.y() / 2, size.z() / 2), 0);
        }
        if (body instanceof Body.Sphere sphere) {
            return new DynamicShape(SPHERE, equal(sphere.radiusMetres()), 0);
        }
        Body.Capsule capsule = (Body.Capsule) body;
        double axis = Math.max(0, capsule.heightMetres() / 2 - capsule.radiusMetres());
        return new DynamicShape(axis > 0 ? CAPSULE : SPHERE, equal(capsule.radiusMetres()), axis);
    }

    static DynamicShape sphere(double radiusMetres) {
        return new DynamicShape(SPHERE, equal(radiusMetres), 0);
    }

    private static Vec3 equal(double x) {
        return new Vec3(x, x, x);
    }

    /** Returns the radius of the bounding sphere about the part's origin. */
    double reachMetres() {
        return kind == SPHERE || kind == CAPSULE ? half.x() + halfAxisMetres : Math.sqrt(half.dot(half));
    }

    /**
     * Returns the part's support point along a world direction, relative to its origin; the centre of all such points
     * if they form an edge or a face.
     */
    Vector3d support(Vec3 direction, Quaterniondc worldFromPart, Vector3d out) {
        worldFromPart.transformInverse(direction.x(), direction.y(), direction.z(), out);
        if (kind == SPHERE || kind == CAPSULE) {
            double length = Math.max(out.length(), 1e-300);
            out.mul(half.x() / length);
            out.y += halfAxisMetres * sign(out.y);
        } else {
            out.set(half.x() * sign(out.x), half.y() * sign(out.y), half.z() * sign(out.z));
        }
        return worldFromPart.transform(out);
    }

    private static double sign(double x) {
        return Math.abs(x) < 1e-9 ? 0 : Math.signum(x);
    }
}
