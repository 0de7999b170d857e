package nephele.engine.portal.ground;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.portal.Portal;

/** How far the ground under a portal, and beside it, lies below it. */
public final class GroundStep {
    /** Said of a portal that is not on ground. */
    public static final double NO_GROUND = -1;

    /** Width of the rim around the aperture that counts as under the portal. */
    public static final double RIM_METRES = ApertureGround.RIM_METRES;

    /** Allowance for rounding and for portals that follow flat ground by least squares. */
    private static final double TOLERANCE_METRES = 1.1e-3;

    private static final int MOST_TRIANGLES = 20_000;

    private static final double MOST_METRES = 2 * GroundSeat.MOST_UNEVEN_METRES + TOLERANCE_METRES;

    private GroundStep() {}

    /**
     * Returns the greatest distance in metres of the ground under aperture and rim from the portal's plane, or {@link
     * #NO_GROUND} if the portal does not lie on one of the terrains.
     */
    public static double below(List<HeightField> terrains, Portal portal) {
        for (HeightField field : terrains) {
            ApertureGround ground = ApertureGround.under(field, portal);
            if (ground.size() > 0 && ground.highest() <= TOLERANCE_METRES && ground.lowest() >= -MOST_METRES) {
                return Math.max(0, -ground.lowest());
            }
        }
        return NO_GROUND;
    }

    /**
     * Returns the depth below a portal's plane of the deepest ground within a distance beside its aperture, as far as the
     * ground is searched: the distance itself if the ground falls farther, ends, or has too many triangles to look at.
     */
    public static double deepest(List<HeightField> terrains, Portal portal, double besideMetres) {
        double x = portal.aperture().widthMetres() / 2 + besideMetres;
        double y = portal.aperture().heightMetres() / 2 + besideMetres;
        List<Vec3> ends = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            ends.add(portal.world(
                    (i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? besideMetres : -besideMetres));
        }
        Aabb box = Aabb.of(ends);
        for (HeightField field : terrains) {
            if (field.bounds().overlaps(box)) {
                return Math.min(besideMetres, deepest(field, portal, box));
            }
        }
        return besideMetres;
    }

    private static double deepest(HeightField field, Portal portal, Aabb box) {
        List<Integer> triangles = new ArrayList<>();
        field.passing((bounds, at) -> triangles.size() <= MOST_TRIANGLES && box.overlaps(bounds, at), triangles::add);
        Aabb all = field.bounds();
        boolean isCovered = all.minX() <= box.minX()
                && box.maxX() <= all.maxX()
                && all.minZ() <= box.minZ()
                && box.maxZ() <= all.maxZ();
        if (!isCovered || triangles.size() > MOST_TRIANGLES) {
            return Double.POSITIVE_INFINITY;
        }
        double least = 0;
        for (int triangle : triangles) {
            for (int corner = 0; corner < 3; corner++) {
                Vec3 at = field.corner(triangle, corner);
                least = Math.min(least, portal.inFront(at.x(), at.y(), at.z()));
            }
        }
        return -least;
    }
}
