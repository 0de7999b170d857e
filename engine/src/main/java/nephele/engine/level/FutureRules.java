package nephele.engine.level;

import java.util.function.Consumer;

/** What is read and checked but is not shown yet, so that nobody looks for it in the picture. */
final class FutureRules {
    private static final String NOT_DRAWN = "is not drawn by this version yet";

    static final LevelRule NOT_YET = (level, assets, report) -> {
        Environment environment = level.environment();
        tell(!environment.clouds().isEmpty(), "environment.clouds", NOT_DRAWN, report);
        tell(environment.sky() instanceof Sky.Atmosphere, "environment.sky", NOT_DRAWN, report);
    };

    private FutureRules() {}

    private static void tell(boolean present, String path, String message, Consumer<Problem> report) {
        if (present) {
            report.accept(Problem.warning(path, message));
        }
    }
}
