package nephele.lab.technique;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.choice.CloudColumns;
import nephele.engine.choice.CloudSituation;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density.Noise;
import nephele.engine.level.Cloud.Extent;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.Weather;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;

/**
 * A node of the table of errors: a cloud of a form with a mean optical depth, at a distance, in the light of a sun. There is one
 * for each form of cloud that a level can have, thin to thick, far to near or around the eye, low sun to high.
 *
 * @param cloud as a sample level has it, with other random numbers
 * @param angularDegrees its least extent seen from the eye
 */
public record TableCase(
        Cloud cloud, AssetSource assets, double opticalDepth, double angularDegrees, double sunDegrees) {
    /** Angular size of a finite cloud around the eye, as {@link CloudSituation} has it. */
    static final double INSIDE_DEGREES = 90;

    private static final double EYE_METRES = 2;
    /** The sun's azimuth from where the eye looks. */
    private static final double AZIMUTH_DEGREES = 60;

    private static final double LIFT_DEGREES = 25;
    private static final double LAYER_FOV_DEGREES = 75;
    private static final double LEAST_BASE_METRES = 30;
    private static final double GREATEST_BASE_METRES = 13_000;
    /** The irradiance of the sun outside of the clouds. */
    public static final Vec3 SUN_IRRADIANCE = new Vec3(3.2, 3, 2.7);
    /** The sky is one colour: air would hide the errors of clouds that are far away, and take long to trace. */
    public static final Sky SKY = new Sky.Constant(new Vec3(0.12, 0.2, 0.35));

    private static final long OTHER_SEEDS = 100;

    private static final double[] DEPTHS = {0.3, 4, 40};
    private static final double[] LAYER_ANGLES = {5, 30, 75};
    private static final double[] ANGLES = {5, 30, INSIDE_DEGREES};
    private static final double[] SUNS = {6, 45};
    private static final List<String> SAMPLES =
            List.of("ellipsoid", "puffs", "grid", "noise", "image", "cumulonimbus", "cumulus", "stratus", "image-grey");

    /** Returns the form of the cloud as the table names it. */
    public String form() {
        return CloudSituation.form(cloud);
    }

    /** Returns false for a layer higher than clouds are, and for a close one whose few dense billows take hours to trace. */
    boolean exists() {
        boolean isSlow = form().equals("layer noise") && opticalDepth >= 40 && angularDegrees > 30;
        return !isLayer() || distanceMetres() <= GREATEST_BASE_METRES && !isSlow;
    }

    /** Returns true if the eye is in the middle of the cloud. */
    public boolean isCrossed() {
        return cloud.extent() instanceof Extent.Volume && angularDegrees >= INSIDE_DEGREES;
    }

    /** Returns true for a layer, false for a volume. */
    public boolean isLayer() {
        return cloud.extent() instanceof Extent.Layer;
    }

    private double leastExtent() {
        if (cloud.extent() instanceof Extent.Layer layer) {
            return layer.thicknessMetres();
        }
        Vec3 size = ((Extent.Volume) cloud.extent()).size();
        return Math.min(size.x(), Math.min(size.y(), size.z()));
    }

    private double distanceMetres() {
        if (isCrossed()) {
            return 0;
        }
        double half = leastExtent() / 2;
        return half / Math.tan(Math.toRadians(angularDegrees) / 2) - half;
    }

    /** Returns the cloud alone, at the distance at which it has its extent. */
    public SkyView sky() {
        Cloud other = otherSeed(cloud);
        Cloud placed = with(other, extent());
        double depth = CloudColumns.meanDepth(
                LoadedClouds.of(environment(placed), assets).flat(0));
        Cloud scaled = placed.withExtinction(placed.extinctionPerMetre() * opticalDepth / depth);
        double aspect = (double) SkyView.WIDTH / SkyView.HEIGHT;
        Vec3 eye = new Vec3(0, EYE_METRES, 0);
        View view = Viewpoints.between(eye, eye.plus(ahead()), fovDegrees(), aspect);
        return SkyView.alone("case", environment(scaled), assets, view);
    }

    private static Cloud otherSeed(Cloud cloud) {
        return cloud.density() instanceof Noise noise
                ? withDensity(
                        cloud,
                        new Noise(
                                noise.seed() + OTHER_SEEDS,
                                noise.featureMetres(),
                                noise.coverage(),
                                noise.erosion(),
                                noise.profile(),
                                noise.coverageMap(),
                                noise.anvil()))
                : cloud;
    }

    private static Cloud withDensity(Cloud cloud, Cloud.Density density) {
        return new Cloud(
                cloud.id(),
                cloud.extent(),
                CloudTechnique.VOLUME,
                density,
                cloud.extinctionPerMetre(),
                cloud.albedo(),
                cloud.phaseG(),
                Cloud.Motion.STILL);
    }

    private static Cloud with(Cloud cloud, Extent extent) {
        return new Cloud(
                cloud.id(),
                extent,
                CloudTechnique.VOLUME,
                cloud.density(),
                cloud.extinctionPerMetre(),
                cloud.albedo(),
                cloud.phaseG(),
                Cloud.Motion.STILL);
    }

    private Environment environment(Cloud only) {
        double up = Math.toRadians(sunDegrees);
        double aside = Math.toRadians(AZIMUTH_DEGREES);
        var towards = new Vec3(Math.cos(up) * Math.sin(aside), Math.sin(up), -Math.cos(up) * Math.cos(aside));
        return new Environment(
                new Sun(towards, SUN_IRRADIANCE, true),
                SKY,
                null,
                Exposure.NEUTRAL,
                ToneCurve.CLIP,
                null,
                List.of(only));
    }

    private static Vec3 ahead() {
        double lift = Math.toRadians(LIFT_DEGREES);
        return new Vec3(0, Math.sin(lift), -Math.cos(lift));
    }

    private Extent extent() {
        if (cloud.extent() instanceof Extent.Layer layer) {
            return new Extent.Layer(
                    Math.max(LEAST_BASE_METRES, distanceMetres() + EYE_METRES), layer.thicknessMetres());
        }
        Vec3 size = ((Extent.Volume) cloud.extent()).size();
        return new Extent.Volume(new Vec3(0, EYE_METRES, 0).plus(ahead().scaled(middleMetres(size))), size);
    }

    /** Returns the distance of the cloud's middle at which its box is as far away as it should be. */
    private double middleMetres(Vec3 size) {
        double near = 0;
        double far = distanceMetres() + size.length();
        for (int i = 0; i < 60; i++) {
            double middle = (near + far) / 2;
            Aabb box = Aabb.around(ahead().scaled(middle), size);
            if (box.nearest(Vec3.ZERO) < distanceMetres()) {
                near = middle;
            } else {
                far = middle;
            }
        }
        return far;
    }

    private double fovDegrees() {
        if (cloud.extent() instanceof Extent.Layer) {
            return LAYER_FOV_DEGREES;
        }
        Vec3 size = ((Extent.Volume) cloud.extent()).size();
        double radius = size.length() / 2;
        double middle = Math.max(middleMetres(size), radius * 0.7);
        return Math.min(100, Math.toDegrees(2 * Math.atan(radius / middle)));
    }

    /** Returns all nodes in the order of the table. */
    public static List<TableCase> all() {
        List<TableCase> nodes = new ArrayList<>();
        OpenedLevel first = sample(SAMPLES.get(0));
        for (String name : SAMPLES) {
            OpenedLevel opened = sample(name);
            add(nodes, opened.level().environment().clouds().get(0), opened.assets());
        }
        Cloud lens = first.level().environment().clouds().get(0);
        add(nodes, layer(lens), first.assets());
        for (Weather weather : List.of(Weather.CIRRUS, Weather.STORM)) {
            List<Cloud> clouds = WeatherClouds.of(weather, 1);
            add(nodes, clouds.get(clouds.size() - 1), first.assets());
        }
        return nodes;
    }

    /** Returns a node for each form and some optical depths. */
    public static List<TableCase> at(double angularDegrees, double sunDegrees, double... depths) {
        List<TableCase> nodes = new ArrayList<>();
        for (TableCase at : all()) {
            for (double depth : at.opticalDepth() == DEPTHS[0] ? depths : new double[0]) {
                if (at.angularDegrees() == angularDegrees && at.sunDegrees() == sunDegrees) {
                    nodes.add(new TableCase(at.cloud(), at.assets(), depth, angularDegrees, sunDegrees));
                }
            }
        }
        return nodes;
    }

    private static OpenedLevel sample(String name) {
        return new LevelName("levels/samples/clouds-" + name + ".json").open();
    }

    private static Cloud layer(Cloud lens) {
        return new Cloud(
                lens.id(),
                new Cloud.Extent.Layer(1000, 400),
                lens.technique(),
                lens.density(),
                lens.extinctionPerMetre(),
                lens.albedo(),
                lens.phaseG());
    }

    private static void add(List<TableCase> nodes, Cloud cloud, AssetSource assets) {
        double[] angles = cloud.extent() instanceof Cloud.Extent.Layer ? LAYER_ANGLES : ANGLES;
        for (double depth : DEPTHS) {
            for (double angle : angles) {
                for (double sun : SUNS) {
                    var at = new TableCase(cloud, assets, depth, angle, sun);
                    if (at.exists()) {
                        nodes.add(at);
                    }
                }
            }
        }
    }
}
