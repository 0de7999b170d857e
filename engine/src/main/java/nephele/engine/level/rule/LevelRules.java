package nephele.engine.level.rule;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;

/** The rules of a level, in the order in which their problems are reported. */
public final class LevelRules {
    /** The rules that open no other file. */
    public static final List<LevelRule> STRUCTURE = List.of(
            IdRules.UNIQUE,
            IdRules.MATERIALS,
            EnvironmentRules.SUN,
            SolidRules.BOUNDED,
            SolidRules.COST,
            CameraRules.VIEW,
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
            PlayerRules.FREE,
            PlayerRules.SOMEWHERE,
            ObserverRules.SEEN,
            ExitRules.REACHABLE,
            GuidanceRules.HINTS,
            GuidanceRules.PAR,
            EmitterRules.COUNT,
            EmitterRules.USED,
            TerrainRules.LAYERS,
            BillboardRules.PLACES,
            BillboardRules.MEANT,
            ImpostorRules.PLANTED,
            ImpostorRules.MATT,
            EnvironmentRules.FOG,
            EnvironmentRules.LIGHTNING,
            EnvironmentRules.TECHNIQUES);

    /** All rules; the last ones read every picture, mesh and height map. */
    public static final List<LevelRule> ALL = all();

    private LevelRules() {}

    private static List<LevelRule> all() {
        List<LevelRule> all = new ArrayList<>(STRUCTURE);
        all.add(AssetRules.READABLE);
        all.add(ModelRules.READABLE);
        all.add(TerrainRules.READABLE);
        all.add(BillboardRules.ROOM);
        return List.copyOf(all);
    }

    /** Returns every problem, errors and warnings. */
    public static List<Problem> check(Level level, AssetSource assets) {
        return check(ALL, level, assets);
    }

    /** Returns the problems that {@code rules} find. */
    public static List<Problem> check(List<LevelRule> rules, Level level, AssetSource assets) {
        List<Problem> problems = new ArrayList<>();
        rules.forEach(rule -> rule.check(level, assets, problems::add));
        return problems;
    }
}
