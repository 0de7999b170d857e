package nephele.engine.portal.placement;

import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;

/** Decides whether a region has a place for an aperture, with any heading on floors and ceilings. */
final class RegionRoom {
    /** Greatest number of obstacles of a search; a region with more is taken for large. */
    private static final int MOST_LIMITS = 150;

    /** Number of headings that are tried over half a turn; a place that fits at others only is too tight to aim at. */
    private static final int HEADINGS = 12;

    /** |N.y| from which a portal's heading follows the shooter's view. */
    private static final double TILTED = 0.8660254037844386;

    private final Aperture aperture;
    private final ForbiddenCentres forbidden = new ForbiddenCentres();
    private final NearestPoint nearest = new NearestPoint(forbidden);

    RegionRoom(Aperture aperture) {
        this.aperture = aperture;
    }

    /** Returns true if the aperture fits somewhere, or if the region has too many limits for a search. */
    boolean fitsIn(Region region) {
        if (region.outline().size() + region.bars().size() > MOST_LIMITS) {
            return true;
        }
        Vec3 up = PortalUpright.on(region.frame().normal(), Basis.WORLD);
        double startX = region.frame().xOf(up);
        double startY = region.frame().yOf(up);
        int headings = Math.abs(region.frame().normal().y()) > TILTED ? HEADINGS : 1;
        for (int i = 0; i < headings; i++) {
            double turn = Math.PI * i / HEADINGS;
            double cos = StrictMath.cos(turn);
            double sin = StrictMath.sin(turn);
            if (fitsIn(region, cos * startX - sin * startY, sin * startX + cos * startY)) {
                return true;
            }
        }
        return false;
    }

    private boolean fitsIn(Region region, double upX, double upY) {
        ReflectedAperture turned = new ReflectedAperture(aperture, upX, upY);
        if (!isAsLarge(region.faces().bounds(), turned)) {
            return false;
        }
        forbidden.begin(turned);
        for (int i = 0; i < region.outline().size(); i++) {
            forbidden.addOutline(region.outline().shape(i));
        }
        for (int i = 0; i < region.bars().size(); i++) {
            forbidden.add(region.bars().shape(i));
        }
        Aabb box = region.faces().bounds();
        Vec3 middle = box.centre();
        double reach = (box.maxX() - box.minX()) + (box.maxY() - box.minY());
        return nearest.find(region, middle.x(), middle.y(), reach);
    }

    /** Compares the bounds only, which excludes most small surfaces without a search. */
    private static boolean isAsLarge(Aabb box, ReflectedAperture turned) {
        double width = 0;
        double height = 0;
        for (int i = 0; i < turned.corners(); i++) {
            for (int j = 0; j < i; j++) {
                width = Math.max(width, Math.abs(turned.x(i) - turned.x(j)));
                height = Math.max(height, Math.abs(turned.y(i) - turned.y(j)));
            }
        }
        double slack = 2 * (Tolerance.OVERLAP + Tolerance.CRACK);
        return width <= box.maxX() - box.minX() + slack && height <= box.maxY() - box.minY() + slack;
    }
}
