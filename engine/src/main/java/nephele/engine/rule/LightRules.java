package nephele.engine.rule;

import java.util.function.Consumer;
import nephele.engine.level.Light;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Vec3;

/** Rules for lights that have no effect or cast too many shadows. */
final class LightRules {
    static final LevelRule CONES = LevelRule.ofRecords((level, report) ->
            LevelRule.each("lights", level.lights(), (path, light) -> light(path, light, report)));

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
}
