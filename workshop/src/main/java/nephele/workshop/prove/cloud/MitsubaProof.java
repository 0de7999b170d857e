package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Traces the levels of Mitsuba's pictures and compares each pixel. */
public final class MitsubaProof implements Proof {
    private static final double MOST_BIAS = 0.007;
    private static final double MOST_BIAS_SIGMAS = 4;
    private static final double LEAST_AGREEING = 0.9975;

    private final Claim claim;
    private final List<String> cases;
    private final String compared;
    private final int samples;

    /** @param compared what a picture's compared pixels are */
    private MitsubaProof(String name, String sentence, List<String> cases, String compared, int samples) {
        this.cases = cases;
        this.compared = compared;
        this.samples = samples;
        claim = new Claim(name, sentence, "pictures", cases.size(), 1);
    }

    /** Light that clouds scatter, between walls that are none. */
    public static MitsubaProof clouds() {
        return new MitsubaProof(
                "cloud-reference",
                "Three clouds traced with 512 samples a pixel have the mean radiance of Mitsuba's pictures"
                        + " within 4 standard errors and 0.7 %, and 99.75 % of the pixels that see the cloud are within"
                        + " 5.",
                ReferenceCase.OF_MITSUBA,
                "pixels that see the cloud",
                512);
    }

    /** Light that bounces between walls. */
    public static MitsubaProof interiors() {
        return new MitsubaProof(
                "interiors",
                "Four rooms of boxes, lit by an emissive box, by sun and sky through a window, by a lamp behind a door"
                        + " and by all walls, traced with 1,024 samples a pixel, have the mean radiance of Mitsuba's"
                        + " pictures within 4 standard errors and 0.7 %, and 99.75 % of their pixels are within 5.",
                ReferenceCase.INTERIORS,
                "pixels that are not black",
                1024);
    }

    @Override
    public Claim claim() {
        return claim;
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        return ProofResult.ofUnits(from, count, progress, unit -> {
            ReferenceCase scene = ReferenceCase.named(cases.get((int) unit));
            return judged(scene.name(), TracedArea.whole(scene, samples, unit, fraction -> {}));
        });
    }

    private ProofResult judged(String name, TracedArea whole) {
        List<String> failures = new ArrayList<>();
        double bias = 0;
        double sigmas = 0;
        for (int channel = 0; channel < 3; channel++) {
            bias = Math.max(bias, Math.abs(whole.bias(channel)));
            sigmas = Math.max(sigmas, Math.abs(whole.biasSigmas(channel)));
        }
        double agreeing = 1 - whole.differing() / (double) whole.cloudy();
        if (!(bias <= MOST_BIAS) || !(sigmas <= MOST_BIAS_SIGMAS) || !(agreeing >= LEAST_AGREEING)) {
            failures.add(String.format(
                    Locale.ROOT,
                    "%s: mean off by %.3f %% or %.1f standard errors, %.3f %% of %d pixels agree",
                    name,
                    100 * bias,
                    sigmas,
                    100 * agreeing,
                    whole.cloudy()));
        }
        return ProofResult.of(
                1,
                failures,
                Figure.greatest(name + ", mean off", 100 * bias, "%"),
                Figure.greatest(name + ", mean off in its error", sigmas, "standard errors"),
                Figure.sum(name + ", " + compared, whole.cloudy(), ""),
                Figure.sum(name + ", pixels that differ", whole.differing(), ""),
                Figure.greatest(name + ", spread of differences", whole.spread(), "standard errors"));
    }
}
