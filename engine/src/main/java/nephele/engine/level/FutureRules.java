package nephele.engine.level;

import java.util.function.Consumer;

/** What is read and checked but has no effect yet, so that nobody looks for it in the picture. */
final class FutureRules {
    static final LevelRule NOT_YET = (level, assets, report) -> {
        Environment environment = level.environment();
        tell(!environment.clouds().isEmpty(), "environment.clouds", "drawn", report);
        tell(environment.fog() != null, "environment.fog", "drawn", report);
        tell(environment.sky() instanceof Sky.Atmosphere, "environment.sky", "drawn", report);
        tell(!level.portals().isEmpty(), "portals", "drawn or simulated", report);
        tell(level.portalGun() != null, "portalGun", "drawn or simulated", report);
        tell(!level.models().isEmpty(), "models", "drawn", report);
        tell(!level.bodies().isEmpty(), "bodies", "drawn or simulated", report);
    };

    private FutureRules() {}

    private static void tell(boolean present, String path, String done, Consumer<Problem> report) {
        if (present) {
            report.accept(Problem.warning(path, "is not " + done + " by this version yet"));
        }
    }
}
