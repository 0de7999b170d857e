package nephele.workshop.prove.geometry;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.RayCast;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Compares rays and swept shapes on height fields with tests of every triangle alone. */
public final class HeightFieldProof implements Proof {
    private static final double MOST_BYTES_A_SAMPLE = 32;

    /** One ray in so many crosses the whole large field and is compared with every triangle. */
    private static final int ACROSS = 2000;

    /** In one unit of so many the depth of a shape in the ground is compared, too. */
    private static final int DEPTHS = 4;

    private static final double LONGEST_RAY_METRES = 64;

    private final int largeSide;

    /** @param largeSide samples along a side of the large field */
    public HeightFieldProof(int largeSide) {
        this.largeSide = largeSide;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "height-field",
                "On height fields of up to 129 x 129 samples a ray and a swept shape meet the triangle that a test of"
                        + " every triangle finds, bit for bit; on one of " + largeSide + " x " + largeSide
                        + " the one that a test of all triangles finds whose bounds meet the query's; a sample takes"
                        + " at most " + (int) MOST_BYTES_A_SAMPLE + " bytes.",
                "rays and sweeps of each size",
                100_000,
                10_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        Comparison comparison = new Comparison(largeSide, progress);
        for (long unit = from; unit < from + count; unit++) {
            comparison.compare(unit);
            progress.unitsDone(unit + 1 - from);
        }
        return comparison.result(count);
    }

    /** The results so far. */
    private static final class Comparison {
        private final Progress progress;
        private final List<Ground> small = new ArrayList<>();
        private final Ground large;
        private final double bytesOfSample;
        private final List<String> failures = new ArrayList<>();
        private final RayCast cast = new RayCast();
        private final Sweep sweep = new Sweep();
        private final Depenetration depenetration = new Depenetration();
        private long raysMet;
        private long sweepsMet;
        private long overlaps;

        Comparison(int largeSide, Progress progress) {
            this.progress = progress;
            HeightFieldSample.small().forEach(field -> small.add(new Ground(field)));
            ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            long before = threads.getCurrentThreadAllocatedBytes();
            HeightField field = HeightFieldSample.large(largeSide);
            long taken = threads.getCurrentThreadAllocatedBytes() - before;
            bytesOfSample = (double) taken / largeSide / largeSide;
            large = new Ground(field);
            if (!(bytesOfSample <= MOST_BYTES_A_SAMPLE)) {
                fail("a sample takes " + bytesOfSample + " bytes");
            }
        }

        void compare(long unit) {
            SplittableRandom random = new SplittableRandom(unit);
            // Larger fields are tested less often, because the larger half costs most of the time.
            Ground ground = small.get(Math.min(random.nextInt(small.size()), random.nextInt(small.size())));
            ray(unit, ground, HeightFieldSample.ray(random, ground.field, 200), limit(random, 400), ground.all());
            Ray ray = HeightFieldSample.ray(random, large.field, LONGEST_RAY_METRES / 2);
            double limit = limit(random, LONGEST_RAY_METRES);
            ray(unit, large, ray, limit, large.within(around(ray, limit)));
            if (unit % ACROSS == 0) {
                ray = HeightFieldSample.across(random, large.field);
                ray(unit, large, ray, Double.POSITIVE_INFINITY, large.all());
            }
            sweep(unit, random, ground, false);
            sweep(unit, random, large, true);
        }

        /** Returns a ray parameter for directions of length up to √3. */
        private static double limit(SplittableRandom random, double metres) {
            return metres * random.nextDouble() / 2;
        }

        private static Aabb around(Ray ray, double limit) {
            return Aabb.of(List.of(ray.at(0), ray.at(limit)));
        }

        private void ray(long unit, Ground ground, Ray ray, double limit, int[] triangles) {
            RayHit entered = new RayHit();
            RayHit met = new RayHit();
            for (int triangle : triangles) {
                offer(entered, triangle, ground.field.entry(ray, triangle), limit);
                offer(met, triangle, ground.field.intersection(ray, triangle), limit);
            }
            boolean isMet = cast.cast(ground.world, ray, limit);
            expect(isMet == entered.item() >= 0 && cast.collider() == entered.item(), "ray", unit, ground);
            expect(!isMet || cast.distance() == entered.distance(), "distance of a ray", unit, ground);
            RayHit found = new RayHit();
            ground.field.nearest(ray, limit, (r, triangle, most) -> ground.field.intersection(r, triangle), found);
            expect(
                    found.item() == met.item() && (met.item() < 0 || found.distance() == met.distance()),
                    "ray from either side",
                    unit,
                    ground);
            raysMet += isMet ? 1 : 0;
        }

        private static void offer(RayHit hit, int triangle, double parameter, double limit) {
            if (parameter <= limit && parameter < Double.POSITIVE_INFINITY) {
                hit.offer(triangle, parameter);
            }
        }

        private void sweep(long unit, SplittableRandom random, Ground ground, boolean isLarge) {
            RoundedHull shape = HeightFieldSample.shape(random);
            Vector3d at = HeightFieldSample.place(random, ground.field);
            Vector3d way = HeightFieldSample.way(random);
            int[] triangles = isLarge ? ground.within(around(shape, at, way)) : ground.all();
            double fraction = 1;
            double depth = 0;
            int first = -1;
            Vector3d normal = new Vector3d();
            for (int triangle : triangles) {
                CollisionWorld alone = ground.alone(triangle);
                if (sweep.cast(alone, shape, at, way) && (first < 0 || sweep.fraction() < fraction)) {
                    fraction = sweep.fraction();
                    first = triangle;
                    normal.set(sweep.normal());
                }
                depth = unit % DEPTHS == 0 ? Math.max(depth, depenetration.depth(alone, shape, at)) : depth;
            }
            sweep.cast(ground.world, shape, at, way);
            expect(sweep.collider() == first && sweep.fraction() == fraction, "sweep", unit, ground);
            expect(first < 0 || sweep.normal().equals(normal), "normal of a sweep", unit, ground);
            if (unit % DEPTHS == 0) {
                expect(depenetration.depth(ground.world, shape, at) == depth, "depth", unit, ground);
                overlaps += depth > 0 ? 1 : 0;
            }
            sweepsMet += first >= 0 ? 1 : 0;
        }

        /** Returns bounds with a margin for the depth of the solid below a triangle and for the skin. */
        private static Aabb around(RoundedHull shape, Vector3d at, Vector3d way) {
            Vector3d end = new Vector3d(at).add(way);
            Vector3d least = new Vector3d(at).min(end).add(shape.least(0), shape.least(1), shape.least(2));
            Vector3d most = new Vector3d(at).max(end).add(shape.greatest(0), shape.greatest(1), shape.greatest(2));
            return new Aabb(least.x, least.y, least.z, most.x, most.y, most.z).grown(0.1);
        }

        private void expect(boolean agrees, String what, long unit, Ground ground) {
            if (!agrees) {
                fail("unit " + unit + ": " + what + " on " + ground.field.triangles() + " triangles");
            }
        }

        private void fail(String example) {
            failures.add(example);
            progress.failed(example);
        }

        ProofResult result(long count) {
            return new ProofResult(
                    count,
                    failures.size(),
                    List.of(
                            Figure.sum("rays that met the ground", raysMet, ""),
                            Figure.sum("sweeps that met it", sweepsMet, ""),
                            Figure.sum("shapes in it", overlaps, ""),
                            Figure.greatest("memory", bytesOfSample, "B a sample")),
                    failures);
        }
    }

    /** A height field as a solid, and each of its triangles alone. */
    private static final class Ground {
        private final HeightField field;
        private final CollisionWorld world;
        private final CollisionWorld[] alone;

        Ground(HeightField field) {
            this.field = field;
            var grid = HeightFieldSample.grid(field);
            world = CollisionWorld.of(new StaticShapes(List.of(), PlacedModels.NONE, List.of(grid)));
            alone = new CollisionWorld[field.triangles() <= 2 * 128 * 128 ? field.triangles() : 0];
        }

        CollisionWorld alone(int triangle) {
            if (triangle >= alone.length) {
                return new CollisionWorld(List.of(world.collider(triangle)));
            }
            if (alone[triangle] == null) {
                alone[triangle] = new CollisionWorld(List.of(world.collider(triangle)));
            }
            return alone[triangle];
        }

        int[] all() {
            return IntStream.range(0, field.triangles()).toArray();
        }

        /** Returns the triangles of all cells that touch a box. */
        int[] within(Aabb box) {
            Aabb all = field.bounds();
            int cells = field.cellColumns();
            int firstColumn = clamp((box.minX() - all.minX()) / field.cellX() - 1, cells);
            int endColumn = clamp((box.maxX() - all.minX()) / field.cellX() + 2, cells);
            int firstRow = clamp((box.minZ() - all.minZ()) / field.cellZ() - 1, field.cellRows());
            int endRow = clamp((box.maxZ() - all.minZ()) / field.cellZ() + 2, field.cellRows());
            var found = IntStream.builder();
            for (int row = firstRow; row < endRow; row++) {
                for (int triangle = 2 * (row * cells + firstColumn);
                        triangle < 2 * (row * cells + endColumn);
                        triangle++) {
                    Aabb bounds = Aabb.of(
                            List.of(field.corner(triangle, 0), field.corner(triangle, 1), field.corner(triangle, 2)));
                    if (bounds.overlaps(box)) {
                        found.add(triangle);
                    }
                }
            }
            return found.build().toArray();
        }

        private static int clamp(double cell, int cells) {
            return (int) Math.max(0, Math.min(cells, cell));
        }
    }
}
