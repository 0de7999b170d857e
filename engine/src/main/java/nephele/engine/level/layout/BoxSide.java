package nephele.engine.level.layout;

import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;

/** Signed distances of a box's corners from a plane, in metres. */
final class BoxSide {
    /** Depth up to which shapes only touch. */
    static final double TOUCHING_METRES = 1e-6;

    private BoxSide() {}

    /** Returns the least signed distance. */
    static double least(Plane plane, Aabb box) {
        return plane.signedDistance(
                plane.nx() > 0 ? box.minX() : box.maxX(),
                plane.ny() > 0 ? box.minY() : box.maxY(),
                plane.nz() > 0 ? box.minZ() : box.maxZ());
    }

    /** Returns the greatest signed distance. */
    static double greatest(Plane plane, Aabb box) {
        return plane.signedDistance(
                plane.nx() > 0 ? box.maxX() : box.minX(),
                plane.ny() > 0 ? box.maxY() : box.minY(),
                plane.nz() > 0 ? box.maxZ() : box.minZ());
    }
}
