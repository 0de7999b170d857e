package nephele.engine.level.layout;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Vec3;

/** The rule that a level without sun and sky, with nothing to see outside, has no gap to the outside. */
public final class LeakRules {
    public static final LevelRule CLOSED = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        List<Vec3> line = hasOutside(level) ? List.of() : Leak.line(level, statics);
        if (!line.isEmpty()) {
            Vec3 gap = line.get(Math.max(0, line.size() - 2));
            String message = "the level leaks: from the start one gets out into the void, near " + rounded(gap)
                    + ": close the gap";
            report.accept(Problem.warning("player.feet", message).about(new Subject(Topic.LEAK, List.of(), line)));
        }
    });

    private LeakRules() {}

    private static boolean hasOutside(Level level) {
        return level.environment().sky() != null || level.environment().sun() != null;
    }

    private static String rounded(Vec3 p) {
        return "[" + rounded(p.x()) + ", " + rounded(p.y()) + ", " + rounded(p.z()) + "]";
    }

    private static double rounded(double metres) {
        return Math.rint(metres * 100) / 100 + 0.0;
    }
}
