package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.Quality.ImpostorChoice;
import nephele.engine.render.gl.GlContext;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Flies by clouds that are drawn from impostors and compares each frame, and each step, with frames without impostors. */
public final class CloudImpostorsProof implements Proof {
    private static final double LEAST_SHARE = 0.95;
    private static final CloudFlight.Path PATH = new CloudFlight.Path(new Vec3(0, 500, 0), 100, 3);
    private static final List<Quality> QUALITIES = List.of(
            Quality.HIGH.with("cloudResolution", 1).with("cloudHistory", CloudHistory.NONE), Quality.HIGH, Quality.LOW);
    private static final List<String> NAMES = List.of("all rays", "high", "low");

    private final String level;
    private final CloudFlight.Size size;
    private final int frames;

    /** Flies for five seconds. */
    public CloudImpostorsProof() {
        this("levels/samples/clouds-impostors.json", new CloudFlight.Size(640, 360), 300);
    }

    CloudImpostorsProof(String level, CloudFlight.Size size, int frames) {
        this.level = level;
        this.size = size;
        this.frames = frames;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-impostors",
                "In " + frames + " frames of a flight by clouds of balls (100 m/s, 3 degrees a second, " + size.width()
                        + " × " + size.height() + " pixels), 95 % of the pixels with an optical depth above 0.01 have a"
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
            try (var gl = GlContext.offscreen();
                    var flight = new CloudFlight(
                            gl, opened, PATH, quality, quality.with("impostors", ImpostorChoice.OFF), size)) {
                var tolerance = new PixelTolerance(opened.level().environment().clouds());
                result = result.and(flown(NAMES.get((int) unit), flight, tolerance));
                gl.requireNoError("flight");
            }
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    private ProofResult flown(String name, CloudFlight flight, PixelTolerance tolerance) {
        var tally = new FlightTally(name);
        for (int frame = 0; frame < frames; frame++) {
            LinearPicture reference = flight.reference(frame);
            LinearPicture seen = flight.seen(frame);
            tolerance.add(flight.view(frame), reference, seen);
            tally.add(reference, seen);
        }
        List<String> failures = new ArrayList<>(tally.failures());
        if (!(tolerance.fraction() >= LEAST_SHARE)) {
            failures.add(String.format(Locale.ROOT, "%s: %.4f of pixels inside", name, tolerance.fraction()));
        }
        return ProofResult.of(
                1,
                failures.isEmpty() ? List.of() : List.of(failures.size() + " failures; " + failures.get(0)),
                List.of(
                        Figure.least(name + ", share of pixels inside", tolerance.fraction(), ""),
                        Figure.greatest(name + ", mean difference", tally.mean(), "FLIP"),
                        Figure.greatest(name + ", greatest step beyond", tally.beyond(), "FLIP")));
    }
}
