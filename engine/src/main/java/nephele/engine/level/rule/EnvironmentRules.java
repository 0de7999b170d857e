package nephele.engine.level.rule;

import java.util.function.Consumer;
import nephele.engine.level.Environment;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Sky;
import nephele.engine.level.Weather;

/** Rules for skies that cannot be shown. */
final class EnvironmentRules {
    /** A skybox names as many files as its layout needs, in its order. */
    static final LevelRule SKY_FILES = (level, assets, report) -> {
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            SkyboxOrder.objection(skybox).ifPresent(report);
        }
    };

    /** Warns of features that are read and checked but not drawn yet. */
    static final LevelRule NOT_YET = (level, assets, report) -> {
        Environment environment = level.environment();
        tell(!environment.clouds().isEmpty(), "environment.clouds", report);
        tell(hasClouds(environment.weather()), "environment.weather", report);
    };

    private EnvironmentRules() {}

    private static boolean hasClouds(Weather weather) {
        return weather != null && weather != Weather.CLEAR;
    }

    private static void tell(boolean present, String path, Consumer<Problem> report) {
        if (present) {
            report.accept(
                    Problem.warning(path, "is not drawn by this version yet").about(Topic.NOT_DRAWN_YET));
        }
    }
}
