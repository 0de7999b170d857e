package nephele.workshop.prove.cloud;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.GridField;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.math.Aabb;
import nephele.engine.math.Hash64;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.RandomMean;
import nephele.engine.reference.volume.Deflection;
import nephele.engine.reference.volume.MajorantTracking;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Compares random walks through slabs with the table. Two of three slabs are homogeneous, the third has a density that
 * varies with height, which makes null collisions and changes nothing but the walk.
 */
public final class CloudSlabsProof implements Proof {
    private static final double MOST_SIGMAS = 4;
    private static final double THICKNESS_METRES = 100;
    private static final float[] GRADED = {0.1f, 1, 0.4f, 0, 0.7f, 0.2f, 0.9f, 0.05f, 0.6f};

    private final List<SlabRow> rows = SlabRow.all();

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-slabs",
                "Random walks through 360 slabs of optical depth 0.01 to 100 reflect and transmit what adding-doubling"
                    + " says, from beams and from a uniform sky: within 4 standard errors of at most 0.002 and 2 % of"
                    + " the value (or 1e-5).",
                "rows",
                rows.size(),
                60);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var done = new AtomicLong();
        return LongStream.range(from, from + count)
                .parallel()
                .mapToObj(row -> compared((int) row))
                .peek(result -> progress.unitsDone(done.incrementAndGet()))
                .reduce(ProofResult.NOTHING, ProofResult::and);
    }

    /** Compares the fluxes of one row of the table, numbered from 0. */
    ProofResult compared(int number) {
        SlabRow row = rows.get(number);
        var beam = walk(number, number, row, row.mu0(), row.reflected(), row.transmitted());
        var diffuse = walk(number, ~number, row, SlabWalk.DIFFUSE, row.diffuseReflected(), row.diffuseTransmitted());
        return new ProofResult(1, 0, List.of(), List.of())
                .and(compared(row, "R", beam.reflected(), row.reflected()))
                .and(compared(row, "T", beam.transmitted(), row.transmitted()))
                .and(compared(row, "diffuse R", diffuse.reflected(), row.diffuseReflected()))
                .and(compared(row, "diffuse T", diffuse.transmitted(), row.diffuseTransmitted()));
    }

    private static ProofResult compared(SlabRow row, String flux, RandomMean mean, double reference) {
        double sigmas = (mean.value() - reference) / Math.max(mean.error(), 1e-5);
        List<String> failures = new ArrayList<>();
        if (!(Math.abs(sigmas) <= MOST_SIGMAS) || mean.error() > mostError(reference)) {
            failures.add(String.format(
                    Locale.ROOT,
                    "%s: %s %.6f, not %.6f, error %.1e",
                    row,
                    flux,
                    mean.value(),
                    reference,
                    mean.error()));
        }
        return ProofResult.of(
                0,
                failures,
                Figure.sum("fluxes", 1, ""),
                Figure.greatest("farthest from the table", Math.abs(sigmas), "standard errors"),
                Figure.sum("sum of squared distances", sigmas * sigmas, "of a standard error"));
    }

    private static SlabWalk walk(int number, long seed, SlabRow row, double mu0, double reflected, double transmitted) {
        var medium = new CloudMedium(field(number, row.depth()), row.albedo(), new HenyeyGreenstein(row.g()));
        return new SlabWalk(medium, Hash64.combine(16, seed), mu0, Math.max(paths(reflected), paths(transmitted)));
    }

    static ExtinctionField field(int number, double depth) {
        double infinite = Double.POSITIVE_INFINITY;
        var layer = new Aabb(-infinite, 0, -infinite, infinite, THICKNESS_METRES, infinite);
        if (number % 3 != 0) {
            return new UniformField(layer, depth / THICKNESS_METRES);
        }
        double sum = 0;
        for (float density : GRADED) {
            sum += density;
        }
        var tile = new Aabb(0, 0, 0, 1e5, THICKNESS_METRES, 1e5);
        var grid = new VoxelGrid(1, GRADED.length, 1, tile, GRADED);
        return GridField.repeated(grid, tile, depth / THICKNESS_METRES * GRADED.length / sum);
    }

    /** Returns the paths after which the standard error of a fraction is within its limit, with a tenth to spare. */
    private static long paths(double fraction) {
        double most = mostError(fraction);
        return (long) Math.max(10_000, 1.1 * fraction * (1 - fraction) / (most * most));
    }

    private static double mostError(double fraction) {
        return Math.max(1e-5, Math.min(0.002, 0.02 * fraction));
    }

    /**
     * The fluxes of a homogeneous slab with Henyey-Greenstein phase function, as fractions of the incident flux. Computed by
     * adding-doubling and rounded to 1e-6.
     *
     * @param depth optical depth along the normal
     * @param mu0 cosine of the angle between beam and normal
     * @param reflected of a parallel beam
     * @param transmitted of a parallel beam, with what is not scattered
     * @param diffuseReflected of isotropic incident radiance
     * @param diffuseTransmitted likewise
     */
    private record SlabRow(
            double albedo,
            double g,
            double depth,
            double mu0,
            double reflected,
            double transmitted,
            double diffuseReflected,
            double diffuseTransmitted) {
        private static final String FILE = "slab_truth.csv";

        /** Reads all rows of the table. */
        static List<SlabRow> all() {
            try (var in = SlabRow.class.getResourceAsStream(FILE);
                    var lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII))) {
                return lines.lines().skip(1).map(SlabRow::parsed).toList();
            } catch (IOException problem) {
                throw new UncheckedIOException(FILE, problem);
            }
        }

        private static SlabRow parsed(String line) {
            double[] n = Arrays.stream(line.split(","))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            return new SlabRow(n[0], n[1], n[2], n[3], n[4], n[5], n[7], n[8]);
        }
    }

    /**
     * Walks of photons that fall on a plane-parallel slab from above. A photon has a weight, reduced by the albedo at each
     * collision; weak ones end by Russian roulette, no path is cut off. A weight never exceeds 1, so the variance of a mean
     * m is at most m (1 − m) by the number of paths.
     */
    private static final class SlabWalk {
        /** The incident angle that stands for isotropic radiance. */
        static final double DIFFUSE = Double.NaN;

        private static final double ROULETTE_BELOW = 0.1;
        private static final double SURVIVOR = 0.2;

        private final CloudMedium medium;
        private final SplittableRandom random;
        private final Ray ray = Ray.reusable();
        private final RandomMean reflected;
        private final RandomMean transmitted;

        /**
         * Follows photons.
         *
         * @param mu0 cosine of the incident angle, or {@link #DIFFUSE}
         */
        SlabWalk(CloudMedium medium, long seed, double mu0, long paths) {
            this.medium = medium;
            random = new SplittableRandom(seed);
            double up = 0;
            double upSquared = 0;
            double down = 0;
            double downSquared = 0;
            for (long path = 0; path < paths; path++) {
                double left = leaving(Double.isNaN(mu0) ? Math.sqrt(1 - random.nextDouble()) : mu0);
                if (left > 0) {
                    up += left;
                    upSquared += left * left;
                } else {
                    down -= left;
                    downSquared += left * left;
                }
            }
            reflected = new RandomMean(up / paths, error(up, upSquared, paths));
            transmitted = new RandomMean(down / paths, error(down, downSquared, paths));
        }

        /** Returns the fraction of the incident flux that leaves above. */
        RandomMean reflected() {
            return reflected;
        }

        /** Returns the fraction of the incident flux that leaves below. */
        RandomMean transmitted() {
            return transmitted;
        }

        private static double error(double sum, double squared, long paths) {
            double mean = sum / paths;
            return Math.sqrt(Math.max(0, squared / paths - mean * mean) / paths);
        }

        /** Returns the weight that leaves, negative if it leaves below. */
        private double leaving(double mu0) {
            var direction = new Vec3(Math.sqrt(1 - mu0 * mu0), -mu0, 0);
            var at = new Vec3(0, medium.field().bounds().maxY(), 0);
            double weight = 1;
            while (true) {
                ray.aim(at.x(), at.y(), at.z(), direction.x(), direction.y(), direction.z());
                double metres = MajorantTracking.collision(medium.field(), ray, 0, Double.POSITIVE_INFINITY, random);
                if (metres == Double.POSITIVE_INFINITY) {
                    return direction.y() > 0 ? weight : -weight;
                }
                weight *= medium.albedo();
                if (weight < ROULETTE_BELOW) {
                    if (random.nextDouble() * SURVIVOR >= weight) {
                        return 0;
                    }
                    weight = SURVIVOR;
                }
                at = ray.at(metres);
                direction = Deflection.of(direction, medium.phase().sampleSeparation(random), random);
            }
        }
    }
}
