package nephele.engine.rule;

import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;

/** Rules for an observer that nothing shows or moves. */
final class ObserverRules {
    static final LevelRule SEEN = LevelRule.ofRecords((level, report) -> {
        if (level.observer() == null) {
            return;
        }
        String camera = level.observer().camera();
        if (level.cameras().isEmpty()) {
            report.accept(Problem.error("observer.camera", "the level has no camera that shows the sphere: add one"));
        } else if (camera != null && !has(level, camera)) {
            report.accept(Problem.error(
                    "observer.camera",
                    "there is no camera '" + camera
                            + "': name one of the level, or leave it out for the first camera"));
        }
        if (level.player() == null) {
            report.accept(Problem.error(
                    "observer", "the sphere starts at the player's feet, but there is no player: add one"));
        }
    });

    private ObserverRules() {}

    private static boolean has(Level level, String camera) {
        return level.cameras().stream().anyMatch(one -> camera.equals(one.id()));
    }
}
