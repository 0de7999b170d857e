package nephele.engine.portal.placement;

import java.util.List;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.portal.Portal;

/**
 * Rules for fixed portals that a player would see otherwise than intended: warnings, and an error for a portal on a
 * mirror.
 */
public final class FixedPortalRules {
    /** Greatest overlap that counts as rounding. */
    private static final double LEAST_METRES = 1e-3;

    public static final LevelRule SEEN = new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
        List<Portal> portals = level.portals().stream().map(Portal::of).toList();
        for (int i = 0; i < portals.size(); i++) {
            String path = "portals[" + i + "].centre";
            for (int j = 0; j < i; j++) {
                if (overlap(portals.get(i), portals.get(j))) {
                    report.accept(Problem.warning(path, onTop(j, level.portals().get(j))));
                }
            }
            PortalWall wall = new PortalWall(portals.get(i), level, statics);
            if (wall.uncoveredMetres() > LEAST_METRES) {
                report.accept(Problem.warning(path, overEdge(wall.uncoveredMetres())));
            }
            if (wall.withoutLeave() != null) {
                report.accept(Problem.warning(path, withoutLeave(wall.withoutLeave())));
            }
            if (wall.mirror() != null) {
                report.accept(Problem.error(path, onMirror(wall.mirror())));
            }
            if (wall.hiddenBy() != null) {
                report.accept(Problem.warning(path, wall.isCentreHidden() ? closed(wall) : hidden(wall)));
            }
        }
    });

    private FixedPortalRules() {}

    private static boolean overlap(Portal a, Portal b) {
        PlaneFrame frame = new PlaneFrame(a.centre(), a.frame());
        return a.normal().dot(b.normal()) >= Tolerance.COPLANAR_COSINE
                && Math.abs(frame.height(b.centre())) <= Tolerance.COPLANAR
                && ConvexPolygon.gap(outline(frame, a), outline(frame, b)) < -LEAST_METRES;
    }

    /** Returns a portal's aperture in a plane's coordinates. */
    static ConvexPolygon outline(PlaneFrame frame, Portal portal) {
        double[] corners = new double[2 * portal.aperture().corners()];
        for (int i = 0; i < portal.aperture().corners(); i++) {
            var corner =
                    portal.world(portal.aperture().cornerX(i), portal.aperture().cornerY(i), 0);
            corners[2 * i] = frame.x(corner);
            corners[2 * i + 1] = frame.y(corner);
        }
        return ConvexPolygon.of(corners);
    }

    private static String onTop(int other, PortalSpec portal) {
        return "overlaps portals[" + other + "] ('" + portal.id() + "') in the same plane: where both are, the player"
                + " sees the picture of one of them and both rims: move one of them";
    }

    private static String overEdge(double metres) {
        return "reaches " + Math.round(metres * 1000) + " mm or more over the edge of its surface: the player sees an"
                + " opening in the air there: move it inwards or make it smaller";
    }

    private static String withoutLeave(String face) {
        return "lies on " + face + ", which says that it takes no portals: the player sees it open all the same: move"
                + " it, or leave portalable out there";
    }

    private static String onMirror(String face) {
        return "lies on " + face + ", a mirror, which takes no portals: move it, or give the face another material";
    }

    private static String closed(PortalWall wall) {
        return wall.hiddenBy() + " stands before it: the player sees that instead of the portal, and nothing passes it"
                + " or its partner: move the portal onto the surface in sight";
    }

    private static String hidden(PortalWall wall) {
        return wall.hiddenBy() + " stands before a part of it: the player sees that instead of the portal there: move"
                + " one of them";
    }
}
