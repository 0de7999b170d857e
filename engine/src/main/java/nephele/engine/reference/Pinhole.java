package nephele.engine.reference;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A pinhole camera: every point of the picture corresponds to a ray from the eye.
 *
 * @param eye world metres
 * @param basis orientation, looking along −back
 * @param halfWidth half the picture's width at depth 1: the tangent of half its field of view
 * @param halfHeight likewise
 * @param nearMetres least depth at which a surface is visible
 * @param farMetres greatest such depth; may be infinite
 */
public record Pinhole(Vec3 eye, Basis basis, double halfWidth, double halfHeight, double nearMetres, double farMetres) {
    /**
     * Returns the direction through a point of the picture, of depth 1: a ray's parameter is its depth.
     *
     * @param right 0 at the left border, 1 at the right one; {@code up} likewise from the bottom
     */
    Vector3d direction(double right, double up) {
        Vector3d d = basis.back().toVector().negate();
        d.fma((2 * right - 1) * halfWidth, basis.right().toVector());
        return d.fma((2 * up - 1) * halfHeight, basis.up().toVector());
    }

    /** Returns the angle between neighbouring pixels of a row in a direction, in a picture of a width in pixels. */
    double pixelRadians(Vector3dc direction, int width) {
        double metres = direction.length();
        double sine = basis.right().toVector().dot(direction) / metres;
        return 2 * halfWidth / width * Math.sqrt(1 - sine * sine) / metres;
    }

    /** Returns the camera in words, with all digits: two that differ have different words. */
    @Override
    public String toString() {
        return "at " + words(eye) + " towards " + words(basis.back().negated()) + ", right " + words(basis.right())
                + ", up " + words(basis.up()) + ", half " + halfWidth + " x " + halfHeight + ", depth " + nearMetres
                + " to " + farMetres;
    }

    private static String words(Vec3 v) {
        return v.x() + "," + v.y() + "," + v.z();
    }
}
