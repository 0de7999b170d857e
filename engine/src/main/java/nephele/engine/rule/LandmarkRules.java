package nephele.engine.rule;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Level;
import nephele.engine.level.Place;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions.Stance;

/** The rule that a player who has just begun sees the landmark by looking around; portals and mirrors are left out. */
final class LandmarkRules {
    /** Distance before a point of the sphere from which nothing hides it: it may be on a surface. */
    private static final double TOUCHING_METRES = 0.01;

    static final LevelRule VISIBLE = new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
        if (level.landmark() == null || level.player() == null) {
            return;
        }
        Place landmark = level.landmark();
        Vec3 eye = level.player().feet().plus(new Vec3(0, Stance.STANDING.eyeMetres(), 0));
        if (landmark.contains(eye) || isVisible(eye, landmark, CollisionWorld.of(statics))) {
            return;
        }
        int around = new BrushIndex(statics).holding(landmark.position(), 0);
        if (around >= 0) {
            report.accept(Problem.warning(
                            "landmark.position",
                            "the landmark is inside " + named(level, around) + ", and its sphere is hidden from the"
                                    + " player's start: move it out, or raise radiusMetres")
                    .about(Topic.ENTITY_IN_SOLID));
        } else {
            report.accept(Problem.warning(
                    "landmark.position",
                    "the landmark cannot be seen from the player's start: move it to where nothing hides it, or raise"
                            + " radiusMetres"));
        }
    });

    private LandmarkRules() {}

    private static String named(Level level, int shape) {
        return shape < level.solids().size()
                ? "solids[" + shape + "] ('" + level.solids().get(shape).id() + "')"
                : "a model";
    }

    /** Looks at the sphere's centre and at 26 points of its surface. */
    private static boolean isVisible(Vec3 eye, Place landmark, CollisionWorld world) {
        RayCast cast = new RayCast();
        for (int i = 0; i < 27; i++) {
            Vec3 path = new Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            double unit = path.length() == 0 ? 0 : landmark.radiusMetres() / path.length();
            Vec3 towards = landmark.position().addScaled(unit, path).minus(eye);
            double metres = towards.length();
            double limit = metres - TOUCHING_METRES;
            if (limit <= 0 || !cast.cast(world, Ray.of(eye, towards.scaled(1 / metres)), limit)) {
                return true;
            }
        }
        return false;
    }
}
