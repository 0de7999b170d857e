package nephele.engine.level.rule;

import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;

/** Rules for exits that a player cannot enter, and for a par that nobody can reach. */
final class ExitRules {
    /** The height of a standing player's centre above the feet. */
    private static final double CENTRE_METRES = 0.9;

    static final LevelRule REACHABLE =
            (level, assets, report) -> LevelRule.each("exits", level.exits(), (path, exit) -> {
                if (exit.heightMetres() < CENTRE_METRES) {
                    report.accept(Problem.warning(
                            path + ".heightMetres",
                            "a player who stands in the exit has the centre above it, " + CENTRE_METRES
                                    + " m above the feet: make it higher"));
                }
                LevelRule.each("solids", level.solids(), (solidPath, solid) -> {
                    if (PlayerRules.isStandingIn(solid, exit.feet())) {
                        report.accept(Problem.warning(
                                        path + ".feet",
                                        "the exit's middle is inside " + solidPath + " ('" + solid.id()
                                                + "'): move it out")
                                .about(Topic.ENTITY_IN_SOLID));
                    }
                });
            });

    static final LevelRule PAR = (level, assets, report) -> {
        if (level.par() != null && level.exits().isEmpty()) {
            report.accept(Problem.warning("par", "nothing ends the level: add an exit, or leave the par out"));
        } else if (level.par() != null && level.par().portals() > 0 && level.portalGun() == null) {
            report.accept(Problem.warning("par.portals", "nobody can shoot portals here: add a portalGun, or write 0"));
        }
    };

    private ExitRules() {}
}
