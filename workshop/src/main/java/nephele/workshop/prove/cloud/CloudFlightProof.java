package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Flies through a broken sky and compares each frame, and each step to the next one, with frames of all rays. */
public final class CloudFlightProof implements Proof {
    /** The presets whose frames share rays. */
    private static final List<Quality> PRESETS = List.of(Quality.LOW, Quality.HIGH);

    private static final List<String> NAMES = List.of("low", "high");

    private static final int FROZEN_FRAMES = 16;
    private static final List<Integer> AFTER_CUT = List.of(0, 1, 4, 16);
    private static final CloudFlight.Path PATH = new CloudFlight.Path(new Vec3(0, 1000, 300), 40, 3);

    private final String level;
    private final int width;
    private final int height;
    private final int frames;

    /** Flies for ten seconds. */
    public CloudFlightProof() {
        this("levels/samples/weather-broken.json", 640, 360, 600);
    }

    CloudFlightProof(String level, int width, int height, int frames) {
        this.level = level;
        this.width = width;
        this.height = height;
        this.frames = frames;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-flight",
                "In " + frames + " frames of a slow flight through a broken sky (40 m/s, 3 degrees a second, "
                        + width + " × " + height
                        + " pixels) the FLIP of no step from frame to frame is above that of frames with all rays by"
                        + " more than 0.02. The eye and the time then stand still for 16 frames, and a cut follows in"
                        + " the middle of the flight.",
                "flights",
                PRESETS.size(),
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        OpenedLevel opened = new LevelName(level).open();
        for (long unit = from; unit < from + count; unit++) {
            Quality quality = PRESETS.get((int) unit);
            Quality allRays = quality.with("cloudHistory", CloudHistory.NONE);
            try (var gl = GlContext.offscreen();
                    var picture = RenderTarget.picture(gl, "flight", PixelFormat.RGBA8, width, height);
                    var flight = new CloudFlight(gl, picture, opened, PATH, quality, allRays)) {
                result = result.and(flown(NAMES.get((int) unit), flight));
                gl.requireNoError("flight");
            }
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    private ProofResult flown(String preset, CloudFlight flight) {
        for (int frame = 0; frame < frames; frame++) {
            flight.fly();
        }
        List<Figure> figures = new ArrayList<>();
        figures.add(Figure.greatest(preset + ", greatest step beyond that of all rays", flight.beyond(), "FLIP"));
        figures.add(Figure.greatest(preset + ", mean error", flight.meanError(), "FLIP"));
        figures.add(Figure.greatest(preset + ", greatest error of a frame", flight.worstError(), "FLIP"));
        double flicker = flicker(flight, flight.last());
        figures.add(Figure.greatest(preset + ", flicker while all is frozen", flicker, "FLIP"));
        figures.addAll(ghosts(preset, flight));
        List<String> steep = flight.failures();
        List<String> one =
                steep.isEmpty() ? List.of() : List.of(steep.size() + " steps; " + preset + ", " + steep.get(0));
        return ProofResult.of(1, one, figures);
    }

    /** Returns the mean step between frames of a time and view that stand still after the flight. */
    private double flicker(CloudFlight flight, LinearPicture last) {
        double sum = 0;
        LinearPicture before = last;
        for (int i = 0; i < FROZEN_FRAMES; i++) {
            LinearPicture now = flight.drawn(frames - 1);
            sum += CloudFlight.flip(before, now);
            before = now;
        }
        return sum / FROZEN_FRAMES;
    }

    /** Returns the errors of frames after a cut in the middle of the flight, which goes on. */
    private List<Figure> ghosts(String preset, CloudFlight flight) {
        List<Figure> figures = new ArrayList<>();
        flight.cut();
        for (int n = 0; n <= AFTER_CUT.get(AFTER_CUT.size() - 1); n++) {
            LinearPicture drawn = flight.drawn(frames / 2 + n);
            if (AFTER_CUT.contains(n)) {
                double ghost = CloudFlight.flip(flight.reference(frames / 2 + n), drawn);
                figures.add(Figure.greatest(preset + ", ghost " + n + " frames after a cut", ghost, "FLIP"));
            }
        }
        return figures;
    }
}
