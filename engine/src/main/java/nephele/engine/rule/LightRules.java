package nephele.engine.rule;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.layout.FacePath;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;

/** Rules for lights that have no effect, are inside solids, or cast too many shadows. */
final class LightRules {
    static final LevelRule CONES = LevelRule.ofRecords(
            (level, report) -> LevelRule.each("lights", level.lights(), (path, light) -> light(path, light, report)));

    static final LevelRule SHADOWS = LevelRule.ofRecords((level, report) -> {
        int pictures = 0;
        for (int i = 0; i < level.lights().size() && level.solids().size() > 1; i++) {
            Light light = level.lights().get(i);
            pictures += castsLight(light) ? light.shadowPictures() : 0;
            if (pictures > Light.MOST_SHADOW_PICTURES) {
                report.accept(Problem.warning("lights[" + i + "].castsShadow", tooMany()));
                return;
            }
        }
    });

    /** Depth from which something counts as inside. */
    private static final double DEEP_METRES = 1e-3;

    /** A light is outside solids and reaches something. A camera may look through a wall from inside it. */
    static final LevelRule PLACES = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
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

    private LightRules() {}

    private static boolean castsLight(Light light) {
        return light.castsShadow()
                && light.rangeMetres() > 0
                && !light.radiantIntensity().equals(Vec3.ZERO);
    }

    private static String tooMany() {
        int most = Light.MOST_SHADOW_PICTURES;
        return "at most " + most / 6 + " point lights or " + most + " spots up to 80° wide may cast shadows (a point"
                + " light counts as 6 spots); from here on the weakest"
                + " lights go without: set castsShadow to false";
    }

    private static void light(String path, Light light, Consumer<Problem> report) {
        if (light instanceof Light.Spot spot && spot.innerConeDegrees() > spot.outerConeDegrees()) {
            report.accept(Problem.error(path + ".innerConeDegrees", "must not be larger than outerConeDegrees"));
        }
        if (light.rangeMetres() == 0) {
            report.accept(Problem.warning(path + ".rangeMetres", "with a range of 0 the light reaches nothing")
                    .about(Topic.LIGHT_WITHOUT_EFFECT));
        } else if (light.radiantIntensity().equals(Vec3.ZERO)) {
            report.accept(Problem.warning(path + ".radiantIntensity", "the light is dark: give it an intensity")
                    .about(Topic.LIGHT_WITHOUT_EFFECT));
        }
    }

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
