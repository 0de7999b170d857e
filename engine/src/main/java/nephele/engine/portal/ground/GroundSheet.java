package nephele.engine.portal.ground;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.portal.Portal;

/** The part of a portal's plane around it that is over a terrain. */
public final class GroundSheet {
    private GroundSheet() {}

    /**
     * Returns the corners of a square in the portal's plane without what is beside the terrain, counter-clockwise seen from
     * in front; less than three if nothing is left.
     *
     * @param reachMetres half of the square's side
     */
    public static List<Vec3> around(Portal portal, double reachMetres, HeightField field) {
        double r = reachMetres;
        List<Vec3> corners =
                List.of(portal.world(-r, -r, 0), portal.world(r, -r, 0), portal.world(r, r, 0), portal.world(-r, r, 0));
        Vec3 east = new Vec3(1, 0, 0);
        Vec3 south = new Vec3(0, 0, 1);
        corners = cut(corners, east, field.x(field.cellColumns()));
        corners = cut(corners, east.negated(), -field.x(0));
        corners = cut(corners, south, field.z(field.cellRows()));
        return cut(corners, south.negated(), -field.z(0));
    }

    /** Keeps what is at most so far along a direction. */
    private static List<Vec3> cut(List<Vec3> corners, Vec3 direction, double most) {
        List<Vec3> left = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            Vec3 a = corners.get(i);
            Vec3 b = corners.get((i + 1) % corners.size());
            double beyondA = direction.dot(a) - most;
            double beyondB = direction.dot(b) - most;
            if (beyondA <= 0) {
                left.add(a);
            }
            if (beyondA < 0 && beyondB > 0 || beyondA > 0 && beyondB < 0) {
                left.add(a.addScaled(beyondA / (beyondA - beyondB), b.minus(a)));
            }
        }
        return left;
    }
}
