package nephele.lab.technique;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.engine.choice.ErrorTable;
import nephele.engine.choice.ErrorTable.Row;
import nephele.engine.choice.TechniqueChoice;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.measure.LinearPicture;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;

/** Measures the table of errors, node by node; a run that was stopped goes on where it was. */
public final class TableMaker {
    private static final int SAMPLES = 256;
    /** Paths inside a cloud and close to it are long. */
    private static final int SAMPLES_NEAR = 128;

    private static final double NEAR_DEGREES = 60;

    private final Path file;
    private final TracedSkies traced;
    private final Stopwatch watch = new Stopwatch();
    private final List<Row> rows = new ArrayList<>();

    /** @param file where the rows are kept, a CSV file as {@link ErrorTable} reads it */
    public TableMaker(Path file) throws IOException {
        this.file = file;
        traced = TracedSkies.in(file.resolveSibling(TracedSkies.FILE));
        if (Files.exists(file)) {
            rows.addAll(ErrorTable.read(TextFile.lines(file), file.toString()).rows());
        }
    }

    /** Measures what the file does not have and returns the table. */
    public ErrorTable make(DoubleConsumer progress) throws IOException {
        List<TableCase> nodes = TableCase.all();
        try (GlContext gl = GlContext.offscreen()) {
            for (int i = 0; i < nodes.size(); i++) {
                TableCase at = nodes.get(i);
                List<CloudTechnique> missing = techniques(at.cloud()).stream()
                        .filter(technique -> !at.isCrossed() || TechniqueChoice.isCrossable(technique))
                        .filter(technique -> !isKnown(at, technique))
                        .toList();
                if (!missing.isEmpty()) {
                    measure(gl, at, missing);
                    var lines = String.join("\n", new ErrorTable(rows).lines()) + "\n";
                    AtomicFile.write(file, lines.getBytes(StandardCharsets.UTF_8));
                }
                progress.accept((i + 1.0) / nodes.size());
            }
        }
        return new ErrorTable(rows);
    }

    private boolean isKnown(TableCase at, CloudTechnique technique) {
        return rows.stream()
                .anyMatch(row -> isOf(row, at) && row.technique() == technique && row.sunDegrees() == at.sunDegrees());
    }

    private static boolean isOf(Row row, TableCase at) {
        return row.form().equals(at.form())
                && row.opticalDepth() == at.opticalDepth()
                && row.angularDegrees() == at.angularDegrees();
    }

    private void measure(GlContext gl, TableCase at, List<CloudTechnique> techniques) {
        SkyView sky = at.sky();
        TracedSky exact = traced.of(sky, samples(at));
        for (CloudTechnique technique : techniques) {
            LinearPicture drawn = DrawnSky.picture(gl, sky, sky.drawnBy(technique));
            double cost = known(at, technique);
            rows.add(new Row(
                    at.form(),
                    technique,
                    at.opticalDepth(),
                    at.angularDegrees(),
                    at.sunDegrees(),
                    exact.size() == 0 ? 0 : exact.errorPercent(drawn),
                    Double.isNaN(cost) ? DrawnSky.cloudCost(gl, sky, sky.drawnBy(technique), watch) : cost));
        }
    }

    static int samples(TableCase at) {
        return at.angularDegrees() >= NEAR_DEGREES ? SAMPLES_NEAR : SAMPLES;
    }

    /** Returns the cost in another light; NaN if it was not measured. */
    private double known(TableCase at, CloudTechnique technique) {
        return rows.stream()
                .filter(row -> isOf(row, at) && row.technique() == technique)
                .mapToDouble(Row::cost)
                .findFirst()
                .orElse(Double.NaN);
    }

    /** Returns the techniques that can draw a cloud. */
    public static List<CloudTechnique> techniques(Cloud cloud) {
        return cloud.extent() instanceof Cloud.Extent.Layer
                ? List.of(
                        CloudTechnique.SKYBOX,
                        CloudTechnique.SKYPLANE,
                        CloudTechnique.PROCEDURAL,
                        CloudTechnique.VOLUME)
                : List.of(
                        CloudTechnique.SKYBOX,
                        CloudTechnique.SKYPLANE,
                        CloudTechnique.PROCEDURAL,
                        CloudTechnique.BILLBOARD,
                        CloudTechnique.PARTICLES,
                        CloudTechnique.VOLUME);
    }
}
