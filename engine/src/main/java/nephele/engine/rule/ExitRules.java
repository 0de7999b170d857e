package nephele.engine.rule;

import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;

/** Rules for exits that a player cannot enter. */
final class ExitRules {
    /** The height of a standing player's centre above the feet. */
    private static final double CENTRE_METRES = 0.9;

    static final LevelRule REACHABLE = LevelRule.ofRecords((level, report) -> LevelRule.each("exits", level.exits(), (path, exit) -> {
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
            }));

    private ExitRules() {}
}
