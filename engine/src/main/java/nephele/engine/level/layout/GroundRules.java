package nephele.engine.level.layout;

import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.json.NumberText;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** The player and bodies start above terrains: below one there is nothing to stand on, and they fall for ever. */
public final class GroundRules {
    public static final LevelRule ABOVE = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        if (level.player() != null) {
            Vec3 feet = level.player().feet();
            double ground = above(statics, feet);
            if (feet.y() < ground - 1e-3) {
                report.accept(Problem.error("player.feet", "the player starts below the ground" + remedy(ground))
                        .about(Topic.ENTITY_IN_SOLID));
            }
        }
        for (int i = 0; i < level.bodies().size(); i++) {
            Vec3 centre = level.bodies().get(i).centre();
            double ground = above(statics, centre);
            if (centre.y() < ground) {
                report.accept(Problem.error(
                                "bodies[" + i + "].centre", "the body's middle is below the ground" + remedy(ground))
                        .about(Topic.ENTITY_IN_SOLID));
            }
        }
    });

    private GroundRules() {}

    private static String remedy(double ground) {
        return ", which is at y = " + NumberText.of(Math.rint(ground * 100) / 100) + " there: move it up";
    }

    /** Returns the y of the lowest ground above a point; negative infinity without. */
    private static double above(StaticShapes statics, Vec3 point) {
        double lowest = Double.POSITIVE_INFINITY;
        for (var grid : statics.ground()) {
            double y = HeightFieldSurface.y(grid.field(), point.x(), point.z());
            if (y <= point.y()) {
                return Double.NEGATIVE_INFINITY;
            }
            lowest = y < lowest ? y : lowest;
        }
        return lowest == Double.POSITIVE_INFINITY ? Double.NEGATIVE_INFINITY : lowest;
    }
}
