package nephele.lab.generate;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A lobe of a crown: an ellipsoid with its axes along x, y and z.
 *
 * @param halfWidth in metres, along x and z
 * @param halfHeight in metres
 */
record Clump(Vector3dc centre, double halfWidth, double halfHeight) {
    /** Returns the point that lies in a direction from the centre, at a multiple of the surface's distance. */
    Vector3d at(Vector3dc direction, double distance) {
        return new Vector3d(direction)
                .mul(halfWidth, halfHeight, halfWidth)
                .mul(distance)
                .add(centre);
    }

    /** Returns the outward normal of the ellipsoid in a direction. */
    Vector3d normal(Vector3dc direction) {
        return new Vector3d(direction).div(halfWidth, halfHeight, halfWidth).normalize();
    }

    /** Returns the distance from the centre as a multiple of the surface's. */
    double depth(Vector3dc point) {
        return new Vector3d(point)
                .sub(centre)
                .div(halfWidth, halfHeight, halfWidth)
                .length();
    }
}
