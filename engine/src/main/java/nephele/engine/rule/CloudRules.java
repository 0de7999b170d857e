package nephele.engine.rule;

import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density.Noise;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.CloudDemand;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.appearance.WeatherCourse;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Aabb;
import nephele.engine.sim.reach.EyeReach;

/** Rules for clouds that show nothing, or other than what their author means. */
final class CloudRules {
    /** Processor's time of a picture from which on somebody waits. */
    private static final double LONG_SECONDS = 10;

    private static final double MUCH_MEMORY_BYTES = 450e6;

    /** Every cloud has something to show, and its keys have an effect on it. */
    static final LevelRule MEANT = LevelRule.ofRecords((level, report) -> {
        Environment environment = level.environment();
        LevelRule.each(
                "environment.clouds", environment.clouds(), (path, cloud) -> cloud(path, cloud, environment, report));
    });

    /** A weather's clouds and the written ones have different ids. */
    static final LevelRule WEATHER = LevelRule.ofRecords((level, report) -> {
        Environment environment = level.environment();
        if (!environment.weatherKeyframes().isEmpty()) {
            keyframes(environment, report);
        } else if (environment.weather() == null) {
            if (environment.weatherSeed() != 0) {
                report.accept(Problem.warning(
                        "environment.weatherSeed", "has no effect without weather: give one, or leave it out"));
            }
            return;
        }
        Set<String> taken = WeatherCourse.of(environment).weathers().stream()
                .flatMap(weather -> WeatherClouds.of(weather, environment.weatherSeed()).stream())
                .map(Cloud::id)
                .collect(Collectors.toSet());
        LevelRule.each("environment.clouds", environment.clouds(), (path, cloud) -> {
            if (taken.contains(cloud.id())) {
                report.accept(Problem.error(
                                path + ".id",
                                "'" + cloud.id() + "' is the id of a cloud of the weather: give it another, or leave"
                                        + " environment.weather out")
                        .about(Topic.DUPLICATE_ID));
            }
        });
    });

    /** The clouds are not so many that a picture of them takes long. */
    static final LevelRule COST = LevelRule.ofRecords((level, report) -> {
        CloudDemand demand = CloudDemand.of(level.environment());
        if (demand.seconds() > LONG_SECONDS || demand.bytes() > MUCH_MEMORY_BYTES) {
            report.accept(Problem.warning(
                    "environment.clouds",
                    demand.clouds() + " clouds need " + demand.words() + " before the first picture: "
                            + "use fewer of them, fewer layers, or the same seed of noise for several"));
        }
    });

    /** A cloud of technique skybox is neither where an eye can be nor where solids are. */
    static final LevelRule FAR = new LevelRule(
            LevelRule.Stage.WORLD,
            (level, assets, statics, report) ->
                    LevelRule.each("environment.clouds", level.environment().clouds(), (path, cloud) -> {
                        if (cloud.technique() != CloudTechnique.SKYBOX) {
                            return;
                        }
                        Aabb bounds = EyeReach.bounds(cloud.extent());
                        EyeReach.Part nearest = EyeReach.of(level, statics).nearest(bounds);
                        if (nearest != null && EyeReach.metresBetween(nearest.box(), bounds) <= 0) {
                            report.accept(Problem.warning(
                                    path + ".technique",
                                    "an eye can be in this cloud "
                                            + nearest.means().words()
                                            + ", and a skybox is a picture from"
                                            + " one point: choose volume or auto, or move the cloud away"));
                        } else if (statics.solids().stream()
                                .anyMatch(solid ->
                                        EyeReach.metresBetween(solid.shape().bounds(), bounds) <= 0)) {
                            report.accept(Problem.warning(
                                    path + ".technique",
                                    "a solid reaches into this cloud, and a skybox is cut there at one distance:"
                                            + " choose volume or auto, or move one of them"));
                        }
                    }));

    /** Puffs of a fill from which on random walks through them are slow. */
    private static final int MANY_PUFFS = 20_000;

    private CloudRules() {}

    private static void keyframes(Environment environment, Consumer<Problem> report) {
        if (environment.weather() != null) {
            report.accept(Problem.error(
                    "environment.weather",
                    "the weather has weatherKeyframes: leave this out, or write it as a keyframe at 0"));
        }
        double before = -1;
        for (int i = 0; i < environment.weatherKeyframes().size(); i++) {
            double time = environment.weatherKeyframes().get(i).timeSeconds();
            if (!(time > before)) {
                report.accept(Problem.error(
                        "environment.weatherKeyframes[" + i + "].timeSeconds",
                        "must be later than the keyframe before: sort them, one for each time"));
            }
            before = time;
        }
    }

    private static void cloud(String path, Cloud cloud, Environment environment, Consumer<Problem> report) {
        motion(path, cloud, report);
        Cloud.BackLobe back = cloud.backLobe();
        if (back.phaseBackG() != 0 && back.phaseBackShare() == 0) {
            report.accept(Problem.warning(
                    path + ".phaseBackG", "has no effect without phaseBackShare: give a share, or leave this out"));
        }
        if (cloud.shafts() && !(environment.sky() instanceof Sky.Atmosphere)) {
            report.accept(Problem.warning(
                    path + ".shafts",
                    "only air shows shadows: choose the environment.sky kind atmosphere, or leave this out"));
        }
        if (cloud.extent() instanceof Cloud.Extent.Layer layer) {
            layer(path, layer, environment, report);
        }
        if (cloud.density() instanceof Cloud.Density.Puffs puffs) {
            puffs(path + ".density", puffs, report);
        } else if (cloud.density() instanceof Noise noise
                && noise.anvil() > 0
                && noise.profile() != CloudProfile.CUMULONIMBUS) {
            report.accept(Problem.warning(
                    path + ".density.anvil",
                    "only the profile cumulonimbus has an anvil: choose it, or leave this out"));
        }
    }

    private static void motion(String path, Cloud cloud, Consumer<Problem> report) {
        Cloud.Motion motion = cloud.motion();
        boolean isLayer = cloud.extent() instanceof Cloud.Extent.Layer;
        if (isLayer && motion.windMetresPerSecond().y() != 0) {
            report.accept(Problem.error(
                    path + ".windMetresPerSecond[1]", "a layer keeps its altitude: write 0 in the middle"));
        }
        if (isLayer && motion.swayMetres().y() != 0) {
            report.accept(Problem.error(path + ".swayMetres[1]", "a layer keeps its altitude: write 0 in the middle"));
        }
        double evolution = motion.evolutionSeconds();
        if (evolution > 0 && !(cloud.density() instanceof Noise) && cloud.technique() != CloudTechnique.PROCEDURAL) {
            report.accept(Problem.warning(path + ".evolutionSeconds", "only noise takes other shapes: leave this out"));
        }
    }

    private static void layer(
            String path, Cloud.Extent.Layer layer, Environment environment, Consumer<Problem> report) {
        boolean isRound = environment.sky() instanceof Sky.Atmosphere;
        if (isRound && layer.baseAltitudeMetres() + layer.thicknessMetres() <= 0) {
            report.accept(Problem.warning(
                    path + ".baseAltitudeMetres", "the layer is below the planet's ground at y = 0: raise it"));
        }
    }

    private static void puffs(String path, Cloud.Density.Puffs puffs, Consumer<Problem> report) {
        Cloud.PuffFill fill = puffs.fill();
        if (fill == null) {
            if (puffs.puffs().isEmpty()) {
                report.accept(Problem.warning(path, "shows nothing: list puffs, or give a fill of boxes"));
            }
        } else if (fill.boxes().isEmpty()) {
            report.accept(Problem.error(path + ".fill.boxes", "has no box to fill: give one with centre and size"));
        } else if (fill.count() == 0) {
            report.accept(Problem.warning(path + ".fill.count", "makes no puff: give some hundred"));
        } else if (fill.count() > MANY_PUFFS) {
            report.accept(
                    Problem.warning(path + ".fill.count", "so many puffs are slow: some thousand fill any cloud"));
        }
    }
}
