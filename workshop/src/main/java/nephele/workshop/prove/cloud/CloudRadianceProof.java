package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.PuffLight;
import nephele.engine.render.gl.GlContext;
import nephele.lab.technique.DrawnSky;
import nephele.lab.technique.SkyView;
import nephele.lab.technique.TableCase;
import nephele.lab.technique.TracedSkies;
import nephele.lab.technique.TracedSky;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Compares the mean radiance of every technique with that of traced pictures, each on the clouds that it is suited for. */
public final class CloudRadianceProof implements Proof {
    private static final int SAMPLES = 512;
    private static final double ANGULAR_DEGREES = 30;
    private static final double SUN_DEGREES = 45;
    private static final double[] SHEET_DEPTHS = {0.3, 2};
    private static final double[] DEPTHS = {0.3, 4, 40};
    private static final String BALLS = "volume puffs";
    /** The limit of what is only recorded. */
    private static final double NONE = Double.POSITIVE_INFINITY;

    private final int samples;
    private final TracedSkies traced = TracedSkies.shipped();

    public CloudRadianceProof() {
        this(SAMPLES);
    }

    CloudRadianceProof(int samples) {
        this.samples = samples;
    }

    /**
     * A cloud drawn by a technique.
     *
     * @param setting the setting that is not the default, with a comma before it; empty for the default
     * @param mostPercent that the mean radiance may be off
     */
    private record Drawn(TableCase at, CloudTechnique technique, String setting, Quality quality, double mostPercent) {
        String name() {
            return word(technique) + setting + ", " + at.form() + " of optical depth "
                    + text("%.1f", at.opticalDepth());
        }
    }

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-radiance",
                "Over the parts of a picture that show clouds, the mean radiance is that of traced pictures within 5 %"
                        + " for volumes, 10 % for particles, 15 % for billboards (both on a heap of puffs) and 10 % for"
                        + " skyplanes of layers of optical depth 0.3 and 2; other settings are recorded.",
                "pictures",
                () -> all().size(),
                4);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        List<Drawn> all = all();
        try (GlContext gl = GlContext.offscreen()) {
            for (long unit = from; unit < from + count; unit++) {
                result = result.and(compared(gl, all.get((int) unit)));
                progress.unitsDone(unit + 1 - from);
            }
        }
        return result;
    }

    private ProofResult compared(GlContext gl, Drawn drawn) {
        SkyView sky = drawn.at().sky();
        TracedSky exact = traced.of(sky, samples);
        double bias = exact.biasPercent(DrawnSky.picture(gl, sky, sky.drawnBy(drawn.technique()), drawn.quality()));
        List<String> failures = new ArrayList<>();
        if (!(Math.abs(bias) <= drawn.mostPercent())) {
            failures.add(text("%s: %.1f %%", drawn.name(), bias));
        }
        return ProofResult.of(1, failures, Figure.sum(drawn.name(), bias, "%"));
    }

    private static List<Drawn> all() {
        List<Drawn> all = new ArrayList<>();
        Quality best = Quality.ULTRA;
        for (TableCase at : TableCase.at(ANGULAR_DEGREES, SUN_DEGREES, DEPTHS)) {
            all.add(new Drawn(at, CloudTechnique.VOLUME, "", best, 5));
            if (at.form().equals(BALLS)) {
                all.add(new Drawn(at, CloudTechnique.PARTICLES, "", best, 10));
                for (PuffLight light : List.of(PuffLight.HARRIS, PuffLight.DOBASHI)) {
                    all.add(new Drawn(
                            at,
                            CloudTechnique.PARTICLES,
                            ", light " + word(light),
                            best.with("particleLight", light),
                            NONE));
                }
                all.add(new Drawn(at, CloudTechnique.BILLBOARD, "", best, 15));
                Quality source = best.with("billboardFacing", Quality.BillboardFacing.SOURCE);
                all.add(new Drawn(at, CloudTechnique.BILLBOARD, ", facing of the source", source, NONE));
            }
        }
        for (TableCase at : TableCase.at(ANGULAR_DEGREES, SUN_DEGREES, SHEET_DEPTHS)) {
            if (at.isLayer()) {
                all.add(new Drawn(at, CloudTechnique.SKYPLANE, "", best, 10));
                all.add(new Drawn(at, CloudTechnique.PROCEDURAL, "", best, NONE));
                for (ProceduralNoise noise : List.of(ProceduralNoise.SOURCE, ProceduralNoise.SOURCE_CODE)) {
                    all.add(new Drawn(
                            at,
                            CloudTechnique.PROCEDURAL,
                            ", noise " + word(noise),
                            best.with("proceduralNoise", noise),
                            NONE));
                }
            }
        }
        return all;
    }

    private static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
