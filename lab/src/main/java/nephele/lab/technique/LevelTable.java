package nephele.lab.technique;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.engine.choice.CloudColumns;
import nephele.engine.choice.CloudSituation;
import nephele.engine.choice.ErrorTable;
import nephele.engine.choice.ErrorTable.Row;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.View;
import nephele.engine.sim.reach.EyeReach;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import nephele.host.terminal.CommandFailure;

/**
 * Errors and costs of techniques for the very clouds of a level, measured from its cameras and kept beside it. Each cloud is
 * alone under the level's sun and the sky of the shipped table, without anything in front of it.
 */
public final class LevelTable {
    private static final int MOST_CAMERAS = 3;
    /** A view that shows less of a cloud tells nothing about it. */
    private static final int LEAST_BLOCKS = 3;

    private final OpenedLevel opened;
    private final Path file;
    private final int samples;
    private final PrintStream log;
    private final Stopwatch watch = new Stopwatch();

    /**
     * Checks that the table can be written beside the level.
     *
     * @param typed the level's file
     * @param samples rays a pixel of the traced pictures
     * @throws CommandFailure if there is no such file or its folder cannot be written to
     */
    public LevelTable(OpenedLevel opened, String typed, int samples, PrintStream log) {
        this.opened = opened;
        this.samples = samples;
        this.log = log;
        Path level = Path.of(typed).toAbsolutePath();
        if (!Files.isRegularFile(level)) {
            throw CommandFailure.input(typed
                    + ": the table of its clouds goes beside the level, which lies in no folder; save a copy first");
        }
        file = level.resolveSibling(ErrorTable.FILE);
        if (!Files.isWritable(level.getParent())) {
            throw CommandFailure.environment(file + ": can't be written, where the table of the level's clouds goes;"
                    + " copy the level to a folder that can be written to");
        }
    }

    /** Measures all clouds of the level and returns the file with their rows and those that it had of others. */
    public Path make() throws IOException {
        Level level = opened.level();
        List<Cloud> clouds = WeatherClouds.all(level.environment()).stream()
                .map(cloud -> cloud.with(CloudTechnique.AUTO))
                .toList();
        Environment auto = alone(level.environment()).withClouds(clouds);
        CloudColumns columns = CloudColumns.of(auto, opened.assets());
        EyeReach reach = EyeReach.of(level, opened.placed().statics());
        double sun = Math.toDegrees(Math.asin(CloudTimeline.towardsSun(auto).y()));
        List<Row> rows = new ArrayList<>();
        try (GlContext gl = GlContext.offscreen()) {
            for (int i = 0; i < clouds.size(); i++) {
                log.println("table of the level's clouds: " + (i + 1) + " of " + clouds.size());
                rows.addAll(rows(
                        gl,
                        clouds.get(i),
                        CloudSituation.of(
                                clouds.get(i),
                                columns.loaded().flat(i).bounds(),
                                columns.meanDepths().get(i),
                                reach,
                                sun)));
            }
        }
        write(file, new ErrorTable(rows));
        return file;
    }

    /** Writes a table, with the rows that the file has of other clouds. */
    static void write(Path file, ErrorTable table) throws IOException {
        ErrorTable all = table;
        if (Files.exists(file)) {
            try {
                all = ErrorTable.read(TextFile.lines(file), file.toString()).refined(table);
            } catch (IllegalArgumentException failure) {
                throw CommandFailure.input(failure.getMessage() + "; delete the file");
            }
        }
        String lines = String.join("\n", all.lines()) + "\n";
        AtomicFile.write(file, lines.getBytes(StandardCharsets.UTF_8));
    }

    private List<Row> rows(GlContext gl, Cloud cloud, CloudSituation at) {
        List<SkyView> skies = skies(cloud);
        List<TracedSky> traced = new ArrayList<>();
        skies.forEach(sky -> traced.add(TracedSky.of(sky, samples)));
        for (int i = skies.size() - 1; i >= 0; i--) {
            if (traced.get(i).size() < LEAST_BLOCKS) {
                skies.remove(i);
                traced.remove(i);
            }
        }
        if (skies.isEmpty()) {
            log.println(cloud.id() + ": no camera looks at it; the shipped table counts for it");
        }
        List<Row> rows = new ArrayList<>();
        for (CloudTechnique technique : skies.isEmpty() ? List.<CloudTechnique>of() : TableMaker.techniques(cloud)) {
            double error = 0;
            double cost = 0;
            for (int i = 0; i < skies.size(); i++) {
                SkyView sky = skies.get(i);
                var placed = sky.drawnBy(technique);
                error = Math.max(error, traced.get(i).errorPercent(DrawnSky.picture(gl, sky, placed)));
                cost += DrawnSky.cloudCost(gl, sky, placed, watch) / skies.size();
            }
            rows.add(row(cloud, technique, at, error, cost));
        }
        return rows;
    }

    private static Row row(Cloud cloud, CloudTechnique technique, CloudSituation at, double error, double cost) {
        return new Row(
                CloudSituation.formOfOnly(cloud),
                technique,
                rounded(at.opticalDepth()),
                rounded(at.angularDegrees()),
                rounded(at.sunDegrees()),
                error,
                cost);
    }

    private static double rounded(double value) {
        return Double.parseDouble(String.format(Locale.ROOT, "%.3f", value));
    }

    /** Returns the cloud seen by some of the level's cameras, or from the player's start if there is none. */
    private List<SkyView> skies(Cloud cloud) {
        Level level = opened.level();
        double aspect = (double) SkyView.WIDTH / SkyView.HEIGHT;
        List<View> views = new ArrayList<>();
        for (Camera camera : level.cameras().stream().limit(MOST_CAMERAS).toList()) {
            views.add(View.ofCamera(camera, 0, aspect));
        }
        if (views.isEmpty()) {
            views.add(Viewpoints.standard(level, opened.file(), aspect).apply(0));
        }
        Environment environment = alone(level.environment()).withClouds(List.of(cloud));
        Level open = Level.of(level.name(), "", environment, level.cameras()).with(level.player(), null);
        List<SkyView> skies = new ArrayList<>();
        views.forEach(view -> skies.add(new SkyView(open, opened.assets(), view)));
        return skies;
    }

    /** Returns the light of the shipped table from the level's direction, without clouds. */
    private static Environment alone(Environment environment) {
        var sun = new Sun(CloudTimeline.towardsSun(environment), TableCase.SUN_IRRADIANCE, true);
        return environment
                .withoutClouds()
                .with(Exposure.NEUTRAL)
                .with(TableCase.SKY)
                .with(sun);
    }
}
