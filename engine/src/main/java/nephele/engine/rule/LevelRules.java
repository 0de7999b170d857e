package nephele.engine.rule;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.layout.Leak;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.LevelRule.Stage;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.portal.placement.FixedPortalRules;
import nephele.engine.portal.placement.RoomRules;

/** All checks of a level, and what applies them. */
public final class LevelRules {
    /** Every check, in the order in which problems are reported. */
    public static final List<LevelRule> ALL = List.of(
            IdRules.UNIQUE,
            IdRules.MATERIALS,
            EnvironmentRules.SUN,
            SolidRules.BOUNDED,
            SolidRules.COST,
            ViewpointRules.CAMERAS,
            LightRules.CONES,
            LightRules.SHADOWS,
            EnvironmentRules.SKY_FILES,
            CloudRules.MEANT,
            CloudRules.WEATHER,
            CloudRules.COST,
            PortalRules.LINKS,
            PortalRules.COUNT,
            PortalRules.ON_SURFACE,
            ModelRules.PARENTS,
            BodyRules.SHAPES,
            MirrorRules.FLAT,
            BodyRules.REACH,
            ViewpointRules.FREE,
            ViewpointRules.SOMEWHERE,
            ViewpointRules.OBSERVER,
            GuidanceRules.EXITS,
            GuidanceRules.HINTS,
            GuidanceRules.PAR,
            EmitterRules.COUNT,
            EmitterRules.USED,
            TerrainRules.LAYERS,
            BillboardRules.PLACES,
            BillboardRules.MEANT,
            ModelRules.PLANTED,
            ModelRules.MATT,
            EnvironmentRules.FOG,
            EnvironmentRules.LIGHTNING,
            EnvironmentRules.TECHNIQUES,
            AssetRules.READABLE,
            ModelRules.READABLE,
            TerrainRules.READABLE,
            BillboardRules.ROOM,
            BodyRules.FREE,
            FixedPortalRules.AS_INTENDED,
            RoomRules.LARGE_ENOUGH,
            SolidRules.THICK,
            SolidRules.IN_SIGHT,
            FaceRules.APART,
            LightRules.PLACES,
            Leak.CLOSED,
            TerrainRules.ABOVE,
            ModelRules.IMPOSTOR_COST,
            GuidanceRules.LANDMARK,
            CloudRules.FAR);

    private LevelRules() {}

    /** Returns the checks of some stages, in the order of {@link #ALL}. */
    public static List<LevelRule> of(Stage... stages) {
        List<Stage> wanted = Arrays.asList(stages);
        return ALL.stream().filter(rule -> wanted.contains(rule.stage())).toList();
    }

    /** Returns every problem, errors and warnings; the world is not checked if a record or file has an error. */
    public static List<Problem> check(Level level, AssetSource assets) {
        List<Problem> problems = new ArrayList<>(checkRecordsAndFiles(level, assets));
        if (level.player() == null && level.cameras().isEmpty()) {
            problems.replaceAll(LevelRules::keepsFromDrawing);
        }
        boolean isDerivable = problems.stream().noneMatch(Problem::isError);
        if (isDerivable && hasShapes(level)) {
            StaticShapes statics = StaticShapes.of(level, assets);
            problems.addAll(check(of(Stage.LAYOUT, Stage.WORLD), level, assets, statics));
        }
        return problems;
    }

    /** Returns the problems that the records have, which opens no other file. */
    public static List<Problem> checkRecords(Level level) {
        return check(of(Stage.RECORDS), level, null, null);
    }

    /** Returns the problems that the records have, and the files that they name. */
    public static List<Problem> checkRecordsAndFiles(Level level, AssetSource assets) {
        return check(of(Stage.RECORDS, Stage.FILES), level, assets, null);
    }

    /**
     * Returns the errors that every command reports when it opens a level: those of the records and of bodies that do not
     * start free. Errors of pictures and meshes are reported when these are read; the other checks are left to
     * {@link #check}.
     *
     * @param statics the level's static shapes; requested only if the starts of bodies have to be checked
     */
    public static List<Problem> errorsBeforeUse(Level level, AssetSource assets, Supplier<StaticShapes> statics) {
        List<Problem> problems = new ArrayList<>(checkRecords(level));
        problems.removeIf(problem -> !problem.isError());
        if (problems.isEmpty() && !level.bodies().isEmpty()) {
            BodyRules.FREE.check().apply(level, assets, statics.get(), problems::add);
        }
        return problems;
    }

    static List<Problem> check(List<LevelRule> rules, Level level, AssetSource assets, StaticShapes statics) {
        List<Problem> problems = new ArrayList<>();
        rules.forEach(rule -> rule.check().apply(level, assets, statics, problems::add));
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
     * Turns the problem of a missing viewpoint into an error: such a level can be simulated, but no command can draw it.
     */
    private static Problem keepsFromDrawing(Problem problem) {
        return problem.path().equals("player")
                ? Problem.error("player", problem.message() + ": add player.feet or a camera")
                        .about(problem.subject())
                : problem;
    }
}
