package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.layout.LayoutRules;
import nephele.engine.level.placed.PlacedRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.rule.LevelRules;
import nephele.engine.portal.placement.FixedPortalRules;
import nephele.engine.portal.placement.RoomRules;
import nephele.engine.sim.reach.CloudReachRules;

/**
 * All rules that {@code check} applies to a level: the rules of its records, then those of the world built from them.
 */
public final class WorldRules {
    /** The rules of the placed world, in the order in which their problems are reported. */
    public static final List<PlacedRule> PLACED = placed();

    private WorldRules() {}

    private static List<PlacedRule> placed() {
        List<PlacedRule> placed = new ArrayList<>(List.of(StartRules.FREE, FixedPortalRules.SEEN));
        placed.add(RoomRules.LARGE_ENOUGH);
        placed.addAll(LayoutRules.ALL);
        placed.add(LandmarkRules.SEEN);
        placed.add(CloudReachRules.FAR);
        return List.copyOf(placed);
    }

    /** Returns every problem, errors and warnings; the world is not checked if a record already has an error. */
    public static List<Problem> check(Level level, AssetSource assets) {
        List<Problem> problems = new ArrayList<>(LevelRules.check(level, assets));
        if (level.player() == null && level.cameras().isEmpty()) {
            problems.replaceAll(WorldRules::keepsFromDrawing);
        }
        boolean isDerivable = problems.stream().noneMatch(Problem::isError);
        if (isDerivable && hasShapes(level)) {
            StaticShapes statics = StaticShapes.of(level, assets);
            PLACED.forEach(rule -> rule.check(level, statics, problems::add));
        }
        return problems;
    }

    private static boolean hasShapes(Level level) {
        return !level.solids().isEmpty()
                || !level.models().isEmpty()
                || !level.terrains().isEmpty()
                || !level.bodies().isEmpty()
                || !level.portals().isEmpty();
    }

    /**
     * Turns the problem of a missing viewpoint into an error: such a level can be simulated, but no command can draw
     * it.
     */
    private static Problem keepsFromDrawing(Problem problem) {
        return problem.path().equals("player")
                ? Problem.error("player", problem.message() + ": add player.feet or a camera")
                        .about(problem.subject())
                : problem;
    }

    /**
     * Returns the errors that every command reports when it opens a level: those of the records' structure and of
     * bodies that do not start free. Errors of pictures and meshes are reported when these are read; the other rules
     * are left to {@link #check}.
     *
     * @param statics the level's static shapes; requested only if the starts of bodies have to be checked
     */
    public static List<Problem> errorsBeforeUse(Level level, AssetSource assets, Supplier<StaticShapes> statics) {
        List<Problem> problems = new ArrayList<>(LevelRules.check(LevelRules.STRUCTURE, level, assets));
        problems.removeIf(problem -> !problem.isError());
        if (problems.isEmpty() && !level.bodies().isEmpty()) {
            StartRules.FREE.check(level, statics.get(), problems::add);
        }
        return problems;
    }
}
