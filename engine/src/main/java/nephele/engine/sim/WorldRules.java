package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.LevelRules;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.PlacedRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.portal.placement.FixedPortalRules;

/** All that {@code check} tells of a level: the rules of its records, then those of the world that follows from it. */
public final class WorldRules {
    /** In the order in which their problems are told. */
    public static final List<PlacedRule> PLACED = List.of(StartRules.FREE, FixedPortalRules.SEEN);

    private WorldRules() {}

    /** Every problem, errors and warnings; where a record is wrong already, no world follows from it. */
    public static List<Problem> check(Level level, AssetSource assets) {
        List<Problem> problems = new ArrayList<>(LevelRules.check(level, assets));
        if (level.player() == null && level.cameras().isEmpty()) {
            problems.replaceAll(WorldRules::keepsFromDrawing);
        }
        boolean isDerivable = problems.stream().noneMatch(Problem::isError);
        if (isDerivable && (!level.bodies().isEmpty() || !level.portals().isEmpty())) {
            StaticShapes statics = StaticShapes.of(level, assets);
            PLACED.forEach(rule -> rule.check(level, statics, problems::add));
        }
        return problems;
    }

    /** A level without a place to look from can be simulated, and no command can draw it. */
    private static Problem keepsFromDrawing(Problem problem) {
        return problem.path().equals("player")
                ? Problem.error("player", problem.message() + ": add player.feet or a camera")
                : problem;
    }

    /**
     * The errors that every command tells when it opens a level: all but those of pictures and meshes, which are told
     * when these are read.
     *
     * @param statics the level's; asked for where bodies may start in them
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
