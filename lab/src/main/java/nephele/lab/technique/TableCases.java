package nephele.lab.technique;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Cloud;
import nephele.engine.level.Weather;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;

/** The nodes of the table of errors: each form of cloud that a level can have, thin to thick, far to near or around the eye, low sun to high. */
public final class TableCases {
    private static final double[] DEPTHS = {0.3, 4, 40};
    private static final double[] LAYER_ANGLES = {5, 30, 75};
    private static final double[] ANGLES = {5, 30, TableCase.INSIDE_DEGREES};
    private static final double[] SUNS = {6, 45};

    private static final List<String> SAMPLES =
            List.of("ellipsoid", "puffs", "grid", "noise", "image", "cumulonimbus", "cumulus", "stratus", "image-grey");

    private TableCases() {}

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
