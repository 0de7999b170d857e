package nephele.engine.portal.placement;

import nephele.engine.math.Aabb;
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
}
