package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.EllipsoidField;
import nephele.engine.cloud.field.PuffsField;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Hash64;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.RandomMean;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.Deflection;
import nephele.engine.reference.volume.MajorantTracking;
import nephele.engine.reference.volume.OutsideLight;
import nephele.engine.reference.volume.VolumeTracer;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/**
 * Compares random walks with the laws of light in clouds that have closed forms. Slabs are 100 m thick; one of three has
 * a density that varies with height.
 */
public final class CloudLawsProof implements Proof {
    private static final int SEED = 4;

    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final double TOP = 100;
    private static final int H_STEPS = 20_000;
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final double[] COSINES = {0.1, 0.25, 0.5, 0.75, 1};

    /** Diffuse transmittance of a conservative isotropic slab of optical depth 1,000, for an upright beam. */
    private static final double DEEP_TRANSMITTANCE = 0.001675;

    private final List<CloudLaw> laws = new ArrayList<>();

    public CloudLawsProof() {
        addTransmittance();
        addGaussianPuff();
        addSingleScattering();
        addFurnace();
        addReciprocity();
        addHFunction();
    }

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-laws",
                "Random walks obey Beer's and Lambert's law, the Gaussian puff's optical depth, the closed forms of"
                    + " light scattered once, the white furnace, reciprocity, and Chandrasekhar's H function (albedo"
                    + " up to 0.99 on slabs of optical depth 200; albedo 1 on 1,000, within their transmittance):"
                    + " within 4 standard errors of at most 0.002.",
                "laws",
                laws.size(),
                40);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var done = new AtomicLong();
        return LongStream.range(from, from + count)
                .parallel()
                .mapToObj(law -> compared((int) law, 1, CloudLaw.MOST_ERROR))
                .peek(result -> progress.unitsDone(done.incrementAndGet()))
                .reduce(ProofResult.NOTHING, ProofResult::and);
    }

    List<CloudLaw> all() {
        return laws;
    }

    /**
     * Compares one law, numbered from 0.
     *
     * @param fraction of the paths at full count
     */
    ProofResult compared(int number, double fraction, double mostError) {
        CloudLaw law = laws.get(number);
        return law.compared(Hash64.combine(SEED, number), (long) (fraction * law.paths()), mostError);
    }

    private void add(String name, double expected, long paths, CloudLaw.Estimate estimate) {
        laws.add(new CloudLaw(name, expected, 0, paths, estimate));
    }

    /** Beer and Lambert, by free flights and by ratio tracking. */
    private void addTransmittance() {
        for (double depth : new double[] {0, 0.01, 0.1, 1, 3, 8}) {
            for (double mu : new double[] {1, 0.5, 0.1}) {
                ExtinctionField slab = CloudSlabsProof.field(laws.size(), depth);
                String of = " of a slab, depth " + depth + ", cosine " + mu;
                double expected = Math.exp(-depth / mu);
                add(
                        "flights" + of,
                        expected,
                        300_000,
                        (paths, seed) -> RandomMean.of(
                                paths,
                                seed,
                                random -> MajorantTracking.collision(slab, down(mu), 0, INFINITE, random) == INFINITE
                                        ? 1
                                        : 0));
                add(
                        "transmittance" + of,
                        expected,
                        300_000,
                        (paths, seed) -> RandomMean.of(
                                paths,
                                seed,
                                random -> MajorantTracking.transmittance(slab, down(mu), 0, INFINITE, random)));
            }
        }
    }

    /** σ s √2π exp(−b²/2s²) at the distance b from the middle, from every direction. */
    private void addGaussianPuff() {
        double deviation = 20;
        double perMetre = 0.04;
        var puff = new PuffsField(List.of(new Cloud.Puff(Vec3.ZERO, 2 * deviation)), new Vec3(3, 4, 5), perMetre);
        for (double off : new double[] {0, 1, 2}) {
            double depth = perMetre * deviation * Math.sqrt(2 * Math.PI) * Math.exp(-off * off / 2);
            add(
                    "puff at " + off + " deviations",
                    Math.exp(-depth),
                    300_000,
                    (paths, seed) -> RandomMean.of(
                            paths,
                            seed,
                            random -> MajorantTracking.transmittance(
                                    puff, beside(new Vec3(3, 4, 5), off * deviation, random), 0, INFINITE, random)));
        }
    }

    /** Returns a ray of random direction that passes a place at a distance. */
    private static Ray beside(Vec3 place, double metres, SplittableRandom random) {
        Vec3 direction = randomDirection(random);
        Vec3 across = Directions.perpendicular(direction);
        double angle = 2 * Math.PI * random.nextDouble();
        Vec3 to = Directions.combined(across, Math.cos(angle), direction.cross(across), Math.sin(angle));
        return Ray.of(place.addScaled(metres, to).addScaled(-500, direction), direction);
    }

    private static Vec3 randomDirection(SplittableRandom random) {
        double y = 2 * random.nextDouble() - 1;
        double angle = 2 * Math.PI * random.nextDouble();
        double r = Math.sqrt(1 - y * y);
        return new Vec3(r * Math.cos(angle), y, r * Math.sin(angle));
    }

    /** Light of a beam, scattered once to an eye above or below a slab. */
    private void addSingleScattering() {
        double[][] cosines = {{1, 1}, {0.5, 1}, {1, 0.5}, {0.1, 0.75}, {-1, 1}, {-0.5, 1}, {-0.25, 0.25}, {-1, 0.5}};
        for (double depth : new double[] {0.01, 0.1, 1, 10, 1e4}) {
            for (double g : new double[] {0, 0.6}) {
                for (double[] pair : cosines) {
                    double mu = pair[0];
                    double mu0 = pair[1];
                    ExtinctionField slab = CloudSlabsProof.field(laws.size(), depth);
                    PhaseFunction phase = new HenyeyGreenstein(g);
                    add(
                            "scattered once, depth " + depth + ", g " + g + ", from " + mu0 + " to " + mu,
                            scatteredOnce(phase, mu, mu0, depth),
                            100_000,
                            (paths, seed) -> scatteredOnce(slab, phase, mu, mu0, paths, seed));
                }
            }
        }
    }

    /**
     * Returns the radiance of a beam that is scattered once in a slab, to an eye above it or below, by the irradiance on a
     * plane perpendicular to the beam, at albedo 1.
     *
     * @param mu cosine of the scattered light, negative below the slab
     * @param mu0 cosine of the beam
     * @param depth of the slab
     */
    static double scatteredOnce(PhaseFunction phase, double mu, double mu0, double depth) {
        double scattered = phase.perSteradian(Deflection.separation(fromEye(mu), sun(mu0)));
        if (mu > 0) {
            return scattered * mu0 / (mu + mu0) * -Math.expm1(-depth * (1 / mu + 1 / mu0));
        }
        double below = -mu;
        return below == mu0
                ? scattered * depth / mu0 * Math.exp(-depth / mu0)
                : scattered * mu0 / (below - mu0) * (Math.exp(-depth / below) - Math.exp(-depth / mu0));
    }

    /** Returns the direction from the eye, against the light. */
    private static Vec3 fromEye(double mu) {
        return new Vec3(Math.sqrt(1 - mu * mu), -mu, 0);
    }

    private static Vec3 sun(double mu0) {
        return new Vec3(0, mu0, Math.sqrt(1 - mu0 * mu0));
    }

    private static RandomMean scatteredOnce(
            ExtinctionField slab, PhaseFunction phase, double mu, double mu0, long paths, long seed) {
        var bounds = slab.bounds();
        Ray ray = Ray.of(new Vec3(0, mu > 0 ? bounds.maxY() : bounds.minY(), 0), fromEye(mu));
        double scattered = phase.perSteradian(Deflection.separation(fromEye(mu), sun(mu0)));
        return RandomMean.of(paths, seed, random -> {
            double at = MajorantTracking.collision(slab, ray, 0, INFINITE, random);
            return at == INFINITE
                    ? 0
                    : scattered
                            * MajorantTracking.transmittance(slab, Ray.of(ray.at(at), sun(mu0)), 0, INFINITE, random);
        });
    }

    /** A white cloud in white light is invisible, from outside and from inside. */
    private void addFurnace() {
        var ball = new EllipsoidField(new Aabb(-60, -40, -50, 60, 40, 50), 0.2);
        var media = new CloudMedia(List.of(
                new CloudMedium(ball, 1, new HenyeyGreenstein(0.85)),
                new CloudMedium(CloudSlabsProof.field(0, 5), 1, new HenyeyGreenstein(-0.5)),
                new CloudMedium(
                        new PuffsField(List.of(new Cloud.Puff(Vec3.ZERO, 30)), new Vec3(30, 10, 0), 0.3),
                        1,
                        new HenyeyGreenstein(0.999))));
        var tracer = new VolumeTracer(media, OutsideLight.of((height, x, y, z) -> new Vector3d(1)));
        for (Vec3 eye : new Vec3[] {Vec3.ZERO, new Vec3(30, 10, 0), new Vec3(0, -300, 20), new Vec3(0, 500, -1e6)}) {
            add(
                    "furnace from " + eye,
                    1,
                    20_000,
                    (paths, seed) -> RandomMean.of(
                            paths, seed, random -> tracer.radiance(Ray.of(eye, randomDirection(random)), random)
                                    .x()));
        }
    }

    /** Exchanging eye and sun exchanges their cosines only. */
    private void addReciprocity() {
        for (double g : new double[] {0, 0.6, 0.85}) {
            for (double depth : new double[] {0.5, 4}) {
                var slab = new CloudMedium(CloudSlabsProof.field(laws.size(), depth), 0.95, new HenyeyGreenstein(g));
                add("reciprocity, g " + g + ", depth " + depth, 0, 400_000, (paths, seed) -> reflected(
                                slab, 0.3, 0.9, paths, seed)
                        .scaled(1 / 0.9)
                        .minus(reflected(slab, 0.9, 0.3, paths, ~seed).scaled(1 / 0.3)));
            }
        }
    }

    private void addHFunction() {
        for (double albedo : new double[] {0.5, 0.8, 0.9, 0.95, 0.99, 1}) {
            double depth = albedo == 1 ? 1000 : 200;
            var slab = new CloudMedium(CloudSlabsProof.field(1, depth), albedo, new HenyeyGreenstein(0));
            for (int eye = 0; eye < COSINES.length; eye++) {
                for (int turn = 1; turn <= 2; turn++) {
                    double mu = COSINES[eye];
                    double mu0 = COSINES[(2 * eye + turn) % COSINES.length];
                    laws.add(new CloudLaw(
                            "H function, albedo " + albedo + ", from " + mu0 + " to " + mu,
                            reflected(albedo, mu, mu0),
                            albedo == 1 ? DEEP_TRANSMITTANCE : 0,
                            albedo == 1 ? 40_000 : 120_000,
                            (paths, seed) -> reflected(slab, mu, mu0, paths, seed)));
                }
            }
        }
    }

    /**
     * Returns the radiance that a semi-infinite medium reflects by the irradiance on a plane perpendicular to the beam.
     *
     * @param albedo 0 to 1; the medium scatters isotropically
     */
    static double reflected(double albedo, double mu, double mu0) {
        return albedo / (4 * Math.PI) * mu0 / (mu + mu0) * hFunction(albedo, mu) * hFunction(albedo, mu0);
    }

    /**
     * Returns the H function of a semi-infinite medium that scatters isotropically, at the cosine of an angle from the
     * normal, by the midpoint rule; errors are below 1e-7. S. Chandrasekhar, "Radiative Transfer", 1950, section 39: ln
     * H(μ) = −(μ/π) ∫ ln(1 − ϖ t cot t) / (cos² t + μ² sin² t) dt from 0 to π/2.
     *
     * @param albedo ϖ, 0 to 1
     */
    static double hFunction(double albedo, double mu) {
        double sum = 0;
        for (int i = 0; i < H_STEPS; i++) {
            double u = (i + 0.5) / H_STEPS;
            // The cube brings the nodes close together at the logarithmic singularity of albedo 1.
            double t = Math.PI / 2 * u * u * u;
            double weight = Math.PI / 2 * 3 * u * u / H_STEPS;
            double cosine = Math.cos(t);
            double sine = Math.sin(t);
            sum += weight * Math.log(escaping(albedo, t, cosine / sine)) / (cosine * cosine + mu * mu * sine * sine);
        }
        return Math.exp(-mu / Math.PI * sum);
    }

    /** Returns 1 − ϖ t cot t; near 0 by its series, as digits would cancel. */
    private static double escaping(double albedo, double t, double cotangent) {
        double absorbed = 1 - albedo;
        return t < 1e-2
                ? absorbed + albedo * t * t * (1.0 / 3 + t * t * (1.0 / 45 + t * t * 2.0 / 945))
                : 1 - albedo * t * cotangent;
    }

    private static RandomMean reflected(CloudMedium slab, double mu, double mu0, long paths, long seed) {
        var light = OutsideLight.of(sun(mu0), ONE, (height, x, y, z) -> new Vector3d());
        var tracer = new VolumeTracer(new CloudMedia(List.of(slab)), light);
        return RandomMean.of(
                paths, seed, random -> tracer.radiance(down(mu), random).x());
    }

    static Ray down(double mu) {
        return new Ray(0, TOP, 0, Math.sqrt(1 - mu * mu), -mu, 0);
    }
}
