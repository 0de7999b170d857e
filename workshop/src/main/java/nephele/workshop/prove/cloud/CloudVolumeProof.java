package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlContext;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Draws six clouds with both models of light scattered often and compares them with traced pictures. */
public final class CloudVolumeProof implements Proof {
    static final List<String> CASES = Stream.concat(ReferenceCase.OF_MITSUBA.stream(), ReferenceCase.OWN.stream())
            .toList();

    private static final double MOST_BIAS = 0.05;
    /** Standard error of a kept picture of our own, as a fraction of the error that is measured with it. */
    private static final double MOST_NOISE = 0.25;

    private static final double MOST_OF_OCTAVES = 1.0 / 3;

    private static final int SIDE = 4;
    private static final int ROUNDS = 6;
    private static final int FRAMES = 3;
    /** Samples a pixel with which a kept picture is traced again: enough to see that its level still means it. */
    private static final int SAMPLES = 64;

    private static final double MOST_SIGMAS = 4;

    private static final String SQUARES = "sum of squares, two streams";
    private static final String OCTAVES_SQUARES = "sum of squares, octaves";
    private static final String NANOS = "CPU time, two streams";
    private static final String OCTAVES_NANOS = "CPU time, octaves";

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-volume",
                "Six drawn clouds have the mean radiance of traced pictures within 5 % (pixels of optical depth above"
                        + " 0.01). The root mean square of their errors is at most a third of that of eight octaves, in"
                        + " none it is greater, at no more cost.",
                "pictures",
                CASES.size(),
                CASES.size());
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        try (GlContext gl = GlContext.offscreen()) {
            return ProofResult.ofUnits(from, count, progress, unit -> {
                ReferenceCase exact = ReferenceCase.named(CASES.get((int) unit));
                return compared(gl, exact, SIDE, ROUNDS).and(retraced(exact));
            });
        }
    }

    /** @param rounds of timing; 0 for none */
    static ProofResult compared(GlContext gl, ReferenceCase exact, int side, int rounds) {
        var scene = new DrawnCase(exact, side);
        try (var ours = scene.new Drawing(gl, CloudScattering.TWO_STREAM);
                var octaves = scene.new Drawing(gl, CloudScattering.OCTAVES)) {
            List<Figure> figures = figures(exact.name(), scene.noise(), ours, octaves);
            var watch = new Stopwatch();
            for (int round = 0; round < rounds; round++) {
                figures.add(Figure.sum(NANOS, ours.nanos(FRAMES, watch), "ns"));
                figures.add(Figure.sum(OCTAVES_NANOS, octaves.nanos(FRAMES, watch), "ns"));
            }
            ProofResult result = ProofResult.of(1, failures(exact.name(), scene.noise(), ours, octaves), List.of());
            for (Figure figure : figures) {
                result = result.and(ProofResult.of(0, List.of(), figure));
            }
            return result;
        }
    }

    private static List<Figure> figures(String name, double noise, DrawnCase.Drawing ours, DrawnCase.Drawing octaves) {
        List<Figure> figures = new ArrayList<>();
        figures.add(Figure.sum(name + ", mean off", 100 * ours.bias(), "%"));
        figures.add(Figure.sum(name + ", RMS of the mean", ours.rootMeanSquare(), ""));
        figures.add(Figure.sum(name + ", noise of the traced picture", noise, ""));
        figures.add(Figure.sum(name + ", octaves, mean off", 100 * octaves.bias(), "%"));
        figures.add(Figure.sum(name + ", octaves, RMS of the mean", octaves.rootMeanSquare(), ""));
        figures.add(Figure.sum(SQUARES, ours.rootMeanSquare() * ours.rootMeanSquare(), ""));
        figures.add(Figure.sum(OCTAVES_SQUARES, octaves.rootMeanSquare() * octaves.rootMeanSquare(), ""));
        return figures;
    }

    private static List<String> failures(String name, double noise, DrawnCase.Drawing ours, DrawnCase.Drawing octaves) {
        List<String> failures = new ArrayList<>();
        if (!(Math.abs(ours.bias()) <= MOST_BIAS)) {
            failures.add(text("%s: mean off by %.1f %%", name, 100 * ours.bias()));
        }
        if (!(ours.rootMeanSquare() <= octaves.rootMeanSquare())) {
            failures.add(text("%s: RMS %.3f, of octaves %.3f", name, ours.rootMeanSquare(), octaves.rootMeanSquare()));
        }
        if (ReferenceCase.OWN.contains(name) && !(noise <= MOST_NOISE * ours.rootMeanSquare())) {
            failures.add(
                    text("%s: noise %.4f of the traced picture hides RMS %.4f", name, noise, ours.rootMeanSquare()));
        }
        return failures;
    }

    /** Traces a kept picture of our own again. */
    private static ProofResult retraced(ReferenceCase exact) {
        if (!ReferenceCase.OWN.contains(exact.name())) {
            return ProofResult.NOTHING;
        }
        TracedArea again = TracedArea.whole(exact, SAMPLES, 7, fraction -> {});
        double sigmas = Math.abs(again.biasSigmas(0));
        List<String> failures = sigmas <= MOST_SIGMAS
                ? List.of()
                : List.of(text("%s: the kept picture is %.1f standard errors off", exact.name(), sigmas));
        return ProofResult.of(
                0, failures, Figure.greatest("kept pictures against traced anew", sigmas, "standard errors"));
    }

    /** Adds what is claimed of all pictures together. */
    @Override
    public ProofResult judged(ProofResult soFar) {
        double rms = Math.sqrt(soFar.value(SQUARES) / soFar.units());
        double octaves = Math.sqrt(soFar.value(OCTAVES_SQUARES) / soFar.units());
        double cost = soFar.value(NANOS) / soFar.value(OCTAVES_NANOS);
        List<String> failures = new ArrayList<>();
        if (!(rms <= MOST_OF_OCTAVES * octaves)) {
            failures.add(text("RMS over all %.3f, of octaves %.3f", rms, octaves));
        }
        if (cost > 1) {
            failures.add(text("%.3f times the cost of octaves", cost));
        }
        List<Figure> figures = new ArrayList<>(soFar.figures());
        figures.removeIf(figure ->
                List.of(SQUARES, OCTAVES_SQUARES, NANOS, OCTAVES_NANOS).contains(figure.name()));
        figures.add(Figure.sum("RMS over all", rms, ""));
        figures.add(Figure.sum("octaves, RMS over all", octaves, ""));
        figures.add(Figure.sum("CPU time of a frame, of octaves'", cost, ""));
        var examples = new ArrayList<>(soFar.examples());
        examples.addAll(failures);
        return new ProofResult(soFar.units(), soFar.failures() + failures.size(), figures, examples);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
