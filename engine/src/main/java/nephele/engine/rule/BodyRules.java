package nephele.engine.rule;

import nephele.engine.level.Body;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;

/** Rules for bodies whose numbers contradict each other. */
final class BodyRules {
    static final LevelRule SHAPES = LevelRule.ofRecords((level, report) -> {
        LevelRule.each("bodies", level.bodies(), (path, body) -> {
            if (body instanceof Body.Capsule capsule && capsule.heightMetres() < 2 * capsule.radiusMetres()) {
                report.accept(Problem.error(
                        path + ".heightMetres",
                        "a capsule is at least as high as it is wide: make it " + 2 * capsule.radiusMetres()
                                + " or more, or a sphere"));
            }
        });
    });

    /** Depth of the space that is opened behind a portal. */
    private static final double MOST_REACH_METRES = 2.5;

    static final LevelRule REACH = LevelRule.ofRecords((level, report) -> {
        boolean hasPortals = level.portalGun() != null || !level.portals().isEmpty();
        LevelRule.each("bodies", level.bodies(), (path, body) -> {
            double reach = reachMetres(body);
            if (hasPortals && reach > MOST_REACH_METRES) {
                report.accept(Problem.warning(
                        path,
                        "reaches " + Math.round(reach * 100) / 100.0
                                + " m from its centre: in a portal, what is farther than " + MOST_REACH_METRES
                                + " m from the plane meets this side's solids"));
            }
        });
    });

    private BodyRules() {}

    private static double reachMetres(Body body) {
        if (body instanceof Body.Box box) {
            return box.size().toVector().length() / 2;
        }
        if (body instanceof Body.Sphere sphere) {
            return sphere.radiusMetres();
        }
        return ((Body.Capsule) body).heightMetres() / 2;
    }
}
