package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.cloud.field.PuffFilling;
import nephele.engine.cloud.field.PuffsField;
import nephele.engine.level.Cloud;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.Quality.ImpostorChoice;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Flies by clouds that are drawn from impostors and compares each frame, and each step, with frames without impostors. */
public final class CloudImpostorsProof implements Proof {
    private static final double LEAST_INSIDE = 0.95;
    private static final CloudFlight.Path PATH = new CloudFlight.Path(new Vec3(0, 500, 0), 100, 3);
    private static final List<Quality> QUALITIES = List.of(
            Quality.HIGH.with("cloudResolution", 1).with("cloudHistory", CloudHistory.NONE), Quality.HIGH, Quality.LOW);
    private static final List<String> NAMES = List.of("all rays", "high", "low");

    private final String level;
    private final int width;
    private final int height;
    private final int frames;

    /** Flies for five seconds. */
    public CloudImpostorsProof() {
        this("levels/samples/clouds-impostors.json", 640, 360, 300);
    }

    CloudImpostorsProof(String level, int width, int height, int frames) {
        this.level = level;
        this.width = width;
        this.height = height;
        this.frames = frames;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-impostors",
                "In " + frames + " frames of a flight by clouds of balls (100 m/s, 3 degrees a second, " + width
                        + " × " + height + " pixels), 95 % of the pixels with an optical depth above 0.01 have a"
                        + " value that the picture without impostors has within a pixel, and the FLIP of no step from"
                        + " frame to frame is above that of frames without impostors by more than 0.02.",
                "flights",
                QUALITIES.size(),
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        OpenedLevel opened = new LevelName(level).open();
        for (long unit = from; unit < from + count; unit++) {
            Quality quality = QUALITIES.get((int) unit);
            Quality whole = quality.with("impostors", ImpostorChoice.OFF);
            try (var gl = GlContext.offscreen();
                    var picture = RenderTarget.picture(gl, "flight", PixelFormat.RGBA8, width, height);
                    var flight = new CloudFlight(gl, picture, opened, PATH, quality, whole)) {
                var tolerance = new PixelTolerance(opened.level().environment().clouds());
                result = result.and(flown(NAMES.get((int) unit), flight, tolerance));
                gl.requireNoError("flight");
            }
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    private ProofResult flown(String name, CloudFlight flight, PixelTolerance tolerance) {
        for (int frame = 0; frame < frames; frame++) {
            flight.fly();
            tolerance.add(flight.view(frame), flight.lastReference(), flight.last());
        }
        List<String> failures = new ArrayList<>();
        flight.failures().forEach(step -> failures.add(name + ", " + step));
        if (!(tolerance.fraction() >= LEAST_INSIDE)) {
            failures.add(String.format(Locale.ROOT, "%s: %.4f of pixels inside", name, tolerance.fraction()));
        }
        return ProofResult.of(
                1,
                failures.isEmpty() ? List.of() : List.of(failures.size() + " failures; " + failures.get(0)),
                List.of(
                        Figure.least(name + ", share of pixels inside", tolerance.fraction(), ""),
                        Figure.greatest(name + ", mean difference", flight.meanError(), "FLIP"),
                        Figure.greatest(name + ", greatest step beyond", flight.beyond(), "FLIP")));
    }

    /**
     * Counts the pixels of clouds that are where they should be: each value of such a pixel is one of those that the
     * right picture has up to a pixel away, or between them. Looks at every fourth pixel along both sides that has an
     * optical depth above 0.01.
     */
    private static final class PixelTolerance {
        private static final int STEP = 4;
        private static final double LEAST_DEPTH = 0.01;
        /** Difference of display values that nobody sees. */
        private static final double CODE = 1 / 255.0;

        private final List<PuffsField> fields = new ArrayList<>();
        private long pixels;
        private long inside;

        /** @param clouds those of puffs count */
        PixelTolerance(List<Cloud> clouds) {
            for (Cloud cloud : clouds) {
                if (cloud.density() instanceof Cloud.Density.Puffs puffs
                        && cloud.extent() instanceof Cloud.Extent.Volume volume) {
                    fields.add(new PuffsField(PuffFilling.all(puffs), volume.centre(), cloud.extinctionPerMetre()));
                }
            }
        }

        void add(View view, LinearPicture reference, LinearPicture drawn) {
            for (int y = 1; y < reference.height() - 1; y += STEP) {
                for (int x = 1; x < reference.width() - 1; x += STEP) {
                    if (depth(view, reference, x, y) > LEAST_DEPTH) {
                        pixels++;
                        inside += isInside(reference, drawn, x, y) ? 1 : 0;
                    }
                }
            }
        }

        private double depth(View view, LinearPicture picture, int x, int y) {
            double right =
                    ((2 * x + 1.0) / picture.width() - 1) * view.projection().tanHalfWidth();
            double up =
                    ((2 * y + 1.0) / picture.height() - 1) * view.projection().tanHalfHeight();
            Vec3 towards = view.right().scaled(right).addScaled(up, view.up()).minus(view.back());
            Ray ray = Ray.of(view.eye(), towards.scaled(1 / towards.length()));
            double depth = 0;
            for (PuffsField field : fields) {
                depth += field.closedDepth(ray, 0, Double.POSITIVE_INFINITY).orElseThrow();
            }
            return depth;
        }

        private static boolean isInside(LinearPicture reference, LinearPicture drawn, int x, int y) {
            for (int channel = 0; channel < 3; channel++) {
                double least = Double.POSITIVE_INFINITY;
                double most = Double.NEGATIVE_INFINITY;
                for (int j = -1; j <= 1; j++) {
                    for (int i = -1; i <= 1; i++) {
                        double value = display(reference, x + i, y + j, channel);
                        least = Math.min(least, value);
                        most = Math.max(most, value);
                    }
                }
                double value = display(drawn, x, y, channel);
                if (value < least - CODE || value > most + CODE) {
                    return false;
                }
            }
            return true;
        }

        /** Returns what a display is sent, 0 to 1. */
        private static double display(LinearPicture picture, int x, int y, int channel) {
            return Math.pow(picture.rgb()[3 * (picture.width() * y + x) + channel], 1 / 2.2);
        }

        double fraction() {
            return (double) inside / pixels;
        }
    }
}
