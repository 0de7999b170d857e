package nephele.engine.level;

import java.util.function.Consumer;

/** Lamps that light something. */
final class LightRules {
    static final LevelRule CONES = (level, assets, report) -> {
        for (int i = 0; i < level.lights().size(); i++) {
            light("lights[" + i + "]", level.lights().get(i), report);
        }
    };

    private LightRules() {}

    private static void light(String path, Light light, Consumer<Problem> report) {
        if (light instanceof Light.Spot spot && spot.innerConeDegrees() > spot.outerConeDegrees()) {
            report.accept(Problem.error(path + ".innerConeDegrees", "must not be larger than outerConeDegrees"));
        }
        if (light.rangeMetres() == 0) {
            report.accept(Problem.warning(path + ".rangeMetres", "with a range of 0 the lamp lights nothing"));
        }
    }
}
