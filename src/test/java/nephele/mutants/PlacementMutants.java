package nephele.mutants;

import static nephele.mutants.Mutant.Area.PLACEMENT;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in portals, paths through them and the placement of shot portals. */
final class PlacementMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    PLACEMENT,
                    "a ceiling counts as a wall",
                    ENGINE + "portal/placement/PortalUpright.java",
                    "steepness = Math.abs(normal.y())",
                    "steepness = normal.y()",
                    "PortalUprightTest"),
            new Mutant(
                    PLACEMENT,
                    "a portal behind the wall is in the way",
                    ENGINE + "portal/placement/RegionFit.java",
                    "Math.abs(frame.height(other.centre()))",
                    "frame.height(other.centre())",
                    "PlacementTest"),
            new Mutant(
                    PLACEMENT,
                    "a portal on uneven ground is in the way of flat shots beyond it",
                    ENGINE + "sim/carry/PlayerActions.java",
                    " && !isOnGround(space, crossing.portal(), end)",
                    "",
                    "GroundPortalTest"),
            new Mutant(
                    PLACEMENT,
                    "a portal holds as long as a shot straight at it would turn it the same way",
                    ENGINE + "portal/placement/Placement.java",
                    "normal -> keptUp(portal.frame(), normal)",
                    "normal -> PortalUpright.on(normal, portal.frame())",
                    "PlacementSurfacesTest"),
            new Mutant(
                    PLACEMENT,
                    "an aperture leans the other way than its portal",
                    ENGINE + "portal/placement/ConvexPolygon.java",
                    "aperture.cornerY(i) * upY - aperture.cornerX(i) * upX",
                    "aperture.cornerY(i) * upY + aperture.cornerX(i) * upX",
                    "ConvexPolygonTest"),
            new Mutant(
                    PLACEMENT,
                    "a point before an edge's first corner is as near as one beside the edge",
                    ENGINE + "portal/placement/ConvexPolygon.java",
                    "Math.max(0, Math.max(-along(i, dx, dy), along(i, dx, dy) - length(i)))",
                    "Math.max(0, along(i, dx, dy) - length(i))",
                    "ConvexPolygonTest"),
            new Mutant(
                    PLACEMENT,
                    "a point that rounding left behind a portal does not enter it",
                    ENGINE + "portal/PortalCrossing.java",
                    "height >= -ROUNDING_METRES",
                    "height >= 0",
                    "PortalCrossingTest"),
            new Mutant(
                    PLACEMENT,
                    "a path behind its second portal is as long as behind its first",
                    ENGINE + "portal/PathTrace.java",
                    "walked += left * crossing.seconds();",
                    "walked += crossing.seconds();",
                    "PathTraceTest"));

    private PlacementMutants() {}
}
