package nephele.engine.rule;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Problem;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;

/** Portals come in pairs that name each other, and lie on the surface of a shape. */
final class PortalRules {
    static final LevelRule LINKS = LevelRule.ofRecords((level, report) -> {
        Map<String, PortalSpec> byId = new HashMap<>();
        level.portals().forEach(portal -> byId.putIfAbsent(portal.id(), portal));
        LevelRule.each("portals", level.portals(), (path, portal) -> link(path, portal, byId, report));
    });

    /** Number of bits of the simulation's portal masks, two of them for a gun's portals. */
    private static final int MOST_PORTALS = 64;

    private static final int PORTALS_OF_A_GUN = 2;

    static final LevelRule COUNT = LevelRule.ofRecords((level, report) -> {
        int most = level.portalGun() == null ? MOST_PORTALS : MOST_PORTALS - PORTALS_OF_A_GUN;
        if (level.portals().size() > most) {
            report.accept(Problem.error(
                    "portals",
                    "has " + level.portals().size() + " portals: a level may have " + MOST_PORTALS + ", or "
                            + (MOST_PORTALS - PORTALS_OF_A_GUN) + " and a gun's two"));
        }
    });

    /** Distance from a face, and cosine between its normal and the portal's (half a degree). */
    private static final double ON_FACE_METRES = 1e-3;

    private static final double ALONG_FACE = 0.99996192306417131;

    /** Greatest distance between uneven ground and the plane of a portal on it. */
    private static final double ABOVE_GROUND_METRES = 0.02;

    /** Checks levels without models; {@link ModelRules#READABLE} checks the others. */
    static final LevelRule ON_SURFACE = LevelRule.ofRecords((level, report) -> {
        if (level.models().isEmpty() && !level.solids().isEmpty()) {
            reportFree(level, PlacedModels.NONE, report);
        }
    });

    private PortalRules() {}

    /** Reports portals that lie on neither a solid nor a model. */
    static void reportFree(Level level, PlacedModels models, Consumer<Problem> report) {
        LevelRule.each("portals", level.portals(), (path, portal) -> {
            boolean isOnSurface = level.solids().stream().anyMatch(solid -> liesOn(portal, solid))
                    || level.terrains().stream().anyMatch(terrain -> mayLieOn(portal.centre(), terrain))
                    || models.all().stream().anyMatch(model -> liesOn(portal, model.triangles()));
            if (!isOnSurface) {
                report.accept(Problem.warning(
                        path + ".centre",
                        "lies on no solid's face that looks along the portal's normal: it opens in free space"));
            }
        });
    }

    /** Returns whether a point is in a terrain's box; its heights are not read, a map may have 67 million. */
    private static boolean mayLieOn(Vec3 point, Terrain terrain) {
        Vec3 centre = terrain.centre();
        double height = point.y() - centre.y();
        return Math.abs(point.x() - centre.x()) <= terrain.sizeMetres().x() / 2
                && Math.abs(point.z() - centre.z()) <= terrain.sizeMetres().z() / 2
                && height >= terrain.heightRangeMetres().low() - ABOVE_GROUND_METRES
                && height <= terrain.heightRangeMetres().high() + ABOVE_GROUND_METRES;
    }

    private static boolean liesOn(PortalSpec portal, WorldTriangles mesh) {
        Vec3 normal = Plane.of(portal.normal(), 0).normal();
        Vec3 p = portal.centre();
        double[] corners = mesh.corners();
        // The ray runs along the normal from a millimetre before the surface to one behind it.
        Vec3 from = p.addScaled(ON_FACE_METRES, normal);
        Ray ray = new Ray(from.x(), from.y(), from.z(), -normal.x(), -normal.y(), -normal.z());
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            double distance = RayTriangleIntersection.hitParameter(ray, corners, 9 * triangle);
            boolean isMet = distance >= 0 && distance <= 2 * ON_FACE_METRES;
            if (isMet && mesh.faceNormal(triangle).dot(normal) >= ALONG_FACE) {
                return true;
            }
        }
        return false;
    }

    private static boolean liesOn(PortalSpec portal, Solid solid) {
        if (!ViewpointRules.mayReach(solid, portal.centre(), ON_FACE_METRES)) {
            return false;
        }
        try {
            return isOnFace(portal, ViewpointRules.planes(solid));
        } catch (IllegalArgumentException reportedByAnotherRule) {
            return true;
        }
    }

    private static boolean isOnFace(PortalSpec portal, List<Plane> planes) {
        Vec3 normal = Plane.of(portal.normal(), 0).normal();
        boolean on = false;
        for (Plane plane : planes) {
            double off = plane.signedDistance(portal.centre());
            double cosine = plane.nx() * normal.x() + plane.ny() * normal.y() + plane.nz() * normal.z();
            on |= cosine >= ALONG_FACE && Math.abs(off) <= ON_FACE_METRES;
            if (off > ON_FACE_METRES) {
                return false;
            }
        }
        return on;
    }

    private static void link(String path, PortalSpec portal, Map<String, PortalSpec> byId, Consumer<Problem> report) {
        PortalSpec partner = byId.get(portal.linkedTo());
        String objection = null;
        if (partner == null) {
            objection = "there is no portal '" + portal.linkedTo() + "'";
        } else if (portal.linkedTo().equals(portal.id())) {
            objection = "a portal cannot lead to itself";
        } else if (!partner.linkedTo().equals(portal.id())) {
            objection = "'" + partner.id() + "' is linked to '" + partner.linkedTo() + "': two portals name each other";
        }
        if (objection != null) {
            report.accept(Problem.error(path + ".linkedTo", objection));
        } else if (partner.widthMetres() != portal.widthMetres() || partner.heightMetres() != portal.heightMetres()) {
            report.accept(Problem.error(
                    path + ".widthMetres", "must be as wide and high as '" + partner.id() + "': portals do not scale"));
        } else if (partner.shape() != portal.shape()) {
            report.accept(Problem.error(
                    path + ".shape", "must be the shape of '" + partner.id() + "': what goes in has to come out"));
        }
        var across = portal.normal().toVector().cross(portal.up().toVector());
        double scale =
                portal.normal().toVector().length() * portal.up().toVector().length();
        if (scale > 0 && across.length() < 1e-6 * scale) {
            report.accept(Problem.error(path + ".up", "must not point along the normal"));
        }
    }
}
