package nephele.engine.level.layout;

import java.util.List;
import java.util.Optional;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;

/** The rule that a light is outside solids and reaches something. A camera may look through a wall from inside it. */
public final class BuriedRules {
    /** Depth from which something counts as inside. */
    private static final double DEEP_METRES = 1e-3;

    public static final LevelRule LIGHTS = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        BrushIndex index = new BrushIndex(statics);
        for (int i = 0; i < level.lights().size(); i++) {
            Light light = level.lights().get(i);
            Optional<PunctualLight> lit = PunctualLight.of(light);
            int around = solidAround(level, index, light.position());
            if (lit.isPresent() && light.castsShadow() && around >= 0) {
                String message = "the light is inside " + FacePath.named(level, around)
                        + ", which shades everything: move it out";
                report.accept(inSolid("lights[" + i + "].position", message, around));
            } else if (lit.isPresent() && isBeyondReach(level, statics, lit.get())) {
                String message = "nothing is within the light's range and cone: move it, or raise rangeMetres";
                report.accept(Problem.warning("lights[" + i + "].rangeMetres", message)
                        .about(Topic.LIGHT_WITHOUT_EFFECT));
            }
        }
    });

    private BuriedRules() {}

    private static Problem inSolid(String path, String message, int solid) {
        return Problem.warning(path, message)
                .about(new Subject(Topic.ENTITY_IN_SOLID, List.of(FacePath.of(solid)), List.of()));
    }

    /** Returns the solid around a point; −1 for none, or for a model. */
    private static int solidAround(Level level, BrushIndex index, Vec3 point) {
        int around = index.holding(point, DEEP_METRES);
        return around < level.solids().size() ? around : -1;
    }

    private static boolean isBeyondReach(Level level, StaticShapes statics, PunctualLight light) {
        boolean hasShapes = !statics.solids().isEmpty()
                || !statics.models().all().isEmpty()
                || !statics.ground().isEmpty();
        // A body may be carried into the light from anywhere.
        return hasShapes
                && level.bodies().isEmpty()
                && statics.all().stream().map(StaticShape::bounds).noneMatch(light::touches);
    }
}
