package nephele.engine.portal.placement;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;

/**
 * A connected part of a plane where portals are permitted.
 *
 * @param faces the region is their union without the bars
 * @param outline segments around that union
 * @param bars obstacles in the union: other faces of the plane, and shapes that touch it
 */
record Region(PlaneFrame frame, PolygonIndex faces, PolygonIndex outline, PolygonIndex bars) {
    /** Returns true if a point is on one of the faces or in a crack between them. */
    boolean covers(double x, double y, ItemList found) {
        return contains(faces, x, y, Tolerance.CRACK, found);
    }

    /** Returns true if a point is on a bar. */
    boolean isBarred(double x, double y, ItemList found) {
        return contains(bars, x, y, 0, found);
    }

    private static boolean contains(PolygonIndex set, double x, double y, double metres, ItemList found) {
        found.clear();
        set.overlapping(new Aabb(x - metres, y - metres, 0, x + metres, y + metres, 0), found);
        for (int i = 0; i < found.size(); i++) {
            if (set.shape(found.get(i)).isWithin(metres, x, y)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns the direction along or across the edge that differs least from another one: of the outline, or of what
     * stands on the region.
     *
     * @param direction of unit length, in the plane
     * @param leastMetres least length of an edge that counts
     * @param mostRadians greatest difference; beyond, the direction itself is returned
     */
    Vec3 nearestAxis(Vec3 direction, double leastMetres, double mostRadians) {
        double x = frame.xOf(direction);
        double y = frame.yOf(direction);
        double[] turn = {StrictMath.tan(mostRadians), Double.NaN, Double.NaN};
        offer(outline, x, y, leastMetres, turn);
        offer(bars, x, y, leastMetres, turn);
        return Double.isNaN(turn[1]) ? direction : frame.worldDirection(turn[1], turn[2]);
    }

    /** @param turn the least tangent so far, and the direction that has it */
    private static void offer(PolygonIndex shapes, double x, double y, double leastMetres, double[] turn) {
        for (int i = 0; i < shapes.size(); i++) {
            ConvexPolygon shape = shapes.shape(i);
            for (int edge = 0; edge < shape.corners(); edge++) {
                if (shape.length(edge) >= leastMetres) {
                    offer(shape.normalX(edge), shape.normalY(edge), x, y, turn);
                }
            }
        }
    }

    private static void offer(double acrossX, double acrossY, double x, double y, double[] turn) {
        double across = acrossX * x + acrossY * y;
        double along = acrossX * y - acrossY * x;
        boolean isAcross = Math.abs(across) >= Math.abs(along);
        double tangent = Math.abs(isAcross ? along / across : across / along);
        if (tangent < turn[0]) {
            double sense = Math.signum(isAcross ? across : along);
            turn[0] = tangent;
            turn[1] = sense * (isAcross ? acrossX : -acrossY);
            turn[2] = sense * (isAcross ? acrossY : acrossX);
        }
    }
}
