package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.PlacedRule;

/**
 * The rule that bodies start free: they overlap neither solids (opened at the fixed portals) nor the player nor each
 * other.
 */
final class StartRules {
    /** The greatest overlap that still counts as touching or rounding. */
    static final double MOST_OVERLAP_METRES = 1e-3;

    /** The greatest number of bodies that are reported; a heap of bodies in one place has millions of pairs. */
    private static final int MOST_TOLD = 50;

    static final PlacedRule FREE = (level, statics, report) -> {
        if (level.bodies().isEmpty()) {
            return;
        }
        StartingBodies bodies = new StartingBodies(level, statics);
        int told = 0;
        for (int i = 0; i < level.bodies().size() && told <= MOST_TOLD; i++) {
            List<String> overlaps = overlaps(level, bodies, i);
            told += overlaps.isEmpty() ? 0 : 1;
            if (told <= MOST_TOLD) {
                tell(i, overlaps, report);
            } else {
                more(report);
            }
        }
    };

    private StartRules() {}

    private static void tell(int body, List<String> overlaps, Consumer<Problem> report) {
        overlaps.forEach(overlap -> report.accept(
                Problem.error("bodies[" + body + "].centre", overlap).about(Topic.ENTITY_IN_SOLID)));
    }

    private static void more(Consumer<Problem> report) {
        report.accept(Problem.error("bodies", "there are more that overlap; these are the first " + MOST_TOLD));
    }

    private static List<String> overlaps(Level level, StartingBodies bodies, int body) {
        List<String> told = new ArrayList<>();
        StartingBodies.Overlap inSolid = bodies.deepestSolid(body);
        if (inSolid.metres() > MOST_OVERLAP_METRES) {
            told.add(message(inSolid, "'" + inSolid.name() + "'", "move it out"));
        }
        StartingBodies.Overlap inBody = bodies.deepestBody(body);
        if (inBody.metres() > MOST_OVERLAP_METRES) {
            Body other = level.bodies().get(inBody.body());
            told.add(message(inBody, "bodies[" + inBody.body() + "] ('" + other.id() + "')", "move one of them"));
        }
        StartingBodies.Overlap inPlayer = bodies.player(body);
        if (inPlayer.metres() > MOST_OVERLAP_METRES) {
            told.add(message(inPlayer, "the player", "move it or player.feet"));
        }
        return told;
    }

    private static String message(StartingBodies.Overlap overlap, String what, String remedy) {
        return "the body starts " + millimetres(overlap.metres()) + " mm deep in " + what
                + (overlap.throughPortal() ? " through a portal" : "") + ": " + remedy;
    }

    private static String millimetres(double metres) {
        double shown = Math.rint(metres * 1e4) / 10;
        return shown == Math.rint(shown) ? Long.toString((long) shown) : Double.toString(shown);
    }
}
