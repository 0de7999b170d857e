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
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Compares rays and swept shapes on height fields with tests of every triangle alone. */
public final class HeightFieldProof implements Proof {
    private static final double FAR_METRES = 1e5;

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
            small().forEach(field -> small.add(new Ground(field)));
            ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            long before = threads.getCurrentThreadAllocatedBytes();
            HeightField field = large(largeSide);
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
            ray(unit, ground, HeightFieldProof.ray(random, ground.field, 200), limit(random, 400), ground.all());
            Ray ray = HeightFieldProof.ray(random, large.field, LONGEST_RAY_METRES / 2);
            double limit = limit(random, LONGEST_RAY_METRES);
            ray(unit, large, ray, limit, large.within(around(ray, limit)));
            if (unit % ACROSS == 0) {
                ray = across(random, large.field);
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
            RoundedHull shape = shape(random);
            Vector3d at = place(random, ground.field);
            Vector3d displacement = displacement(random);
            int[] triangles = isLarge ? ground.within(around(shape, at, displacement)) : ground.all();
            double fraction = 1;
            double depth = 0;
            int first = -1;
            Vector3d normal = new Vector3d();
            for (int triangle : triangles) {
                CollisionWorld alone = ground.alone(triangle);
                if (sweep.cast(alone, shape, at, displacement) && (first < 0 || sweep.fraction() < fraction)) {
                    fraction = sweep.fraction();
                    first = triangle;
                    normal.set(sweep.normal());
                }
                depth = unit % DEPTHS == 0 ? Math.max(depth, depenetration.depth(alone, shape, at)) : depth;
            }
            sweep.cast(ground.world, shape, at, displacement);
            expect(sweep.collider() == first && sweep.fraction() == fraction, "sweep", unit, ground);
            expect(first < 0 || sweep.normal().equals(normal), "normal of a sweep", unit, ground);
            if (unit % DEPTHS == 0) {
                expect(depenetration.depth(ground.world, shape, at) == depth, "depth", unit, ground);
                overlaps += depth > 0 ? 1 : 0;
            }
            sweepsMet += first >= 0 ? 1 : 0;
        }

        /** Returns bounds with a margin for the depth of the solid below a triangle and for the skin. */
        private static Aabb around(RoundedHull shape, Vector3d at, Vector3d displacement) {
            Vector3d end = new Vector3d(at).add(displacement);
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
            var grid = grid(field);
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

    /** Height fields, with rays and shapes placed where rounding and equal distances decide. */
    private enum Relief {
        FLAT,
        HILLS,
        TERRACES,
        SPIKES
    }

    /**
     * Returns fields of one cell to 128 x 128 cells, square or not, at the origin or 100 km away; smaller ones first.
     */
    private static List<HeightField> small() {
        return List.of(
                field(Relief.HILLS, 0, 1, 2, 2),
                field(Relief.SPIKES, 0, 1, 5, 3),
                field(Relief.FLAT, 0, 1, 17, 17),
                field(Relief.TERRACES, 0, 1, 9, 65),
                field(Relief.HILLS, FAR_METRES, 0.25, 33, 33),
                field(Relief.SPIKES, 0, 2, 65, 65),
                field(Relief.HILLS, 0, 1, 129, 129),
                field(Relief.TERRACES, -FAR_METRES, 1, 129, 129));
    }

    /** Returns hills of so many samples along each side, a metre apart. */
    private static HeightField large(int side) {
        return field(Relief.HILLS, 0, 1, side, side);
    }

    /** Returns a field as the ground of a level. */
    private static StaticShape.HeightGrid grid(HeightField field) {
        var terrain = new Terrain(
                "ground", "none", Vec3.ZERO, new Terrain.Sides(1, 1), new Terrain.HeightRange(0, 1), List.of(), false);
        return new StaticShape.HeightGrid(0, terrain, field);
    }

    private static HeightField field(Relief relief, double out, double cellMetres, int columns, int rows) {
        double[] along = waves(columns, 0.05);
        double[] across = waves(rows, 0.07);
        double[] diagonal = waves(columns + rows, 0.31);
        return HeightField.of(new Vec3(out, out / 1000, -out), cellMetres, columns, rows, (column, row) -> {
            double hill = 20 * along[column] * across[row] + 1.5 * diagonal[column + row] + 0.2 * noise(column, row);
            return switch (relief) {
                case FLAT -> 0.5;
                case HILLS -> cellMetres * hill;
                case TERRACES -> Math.floor(hill);
                case SPIKES -> noise(column, row) > 0.8 ? 100 * noise(row, column) : 0;
            };
        });
    }

    private static double[] waves(int count, double step) {
        double[] waves = new double[count];
        for (int i = 0; i < count; i++) {
            waves[i] = StrictMath.sin(step * i);
        }
        return waves;
    }

    /** Returns a random number from 0 to 1. */
    private static double noise(int column, int row) {
        int hash = (column * 0x9e3779b1) ^ (row * 0x85ebca77);
        hash = (hash ^ hash >>> 15) * 0x2c1b3c6d;
        hash = (hash ^ hash >>> 12) * 0x297a2d39;
        return ((hash ^ hash >>> 15) >>> 8) * 0x1p-24;
    }

    /** Returns a corner, a point of an edge or of the diagonal, or any point of a triangle. */
    private static Vector3d surface(SplittableRandom random, HeightField field) {
        int triangle = random.nextInt(field.triangles());
        Vector3d a = field.corner(triangle, 0).toVector();
        Vector3d b = field.corner(triangle, 1).toVector();
        Vector3d c = field.corner(triangle, 2).toVector();
        double s = random.nextDouble();
        return switch (random.nextInt(5)) {
            case 0 -> a;
            case 1 -> a.lerp(c, s);
            case 2 -> b.lerp(c, s);
            case 3 -> a.lerp(b, s);
            default -> a.lerp(b.lerp(c, random.nextDouble()), s);
        };
    }

    private static Vector3d direction(SplittableRandom random) {
        Vector3d any = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        return switch (random.nextInt(6)) {
            case 0 -> new Vector3d(0, random.nextBoolean() ? -1 : 1, 0);
            case 1 -> new Vector3d(random.nextInt(-1, 2), 0, random.nextInt(-1, 2));
            case 2 -> any.mul(1, 1e-6, 1);
            default -> any;
        };
    }

    /**
     * Returns a random, vertical or grazing ray, or one along edges or the diagonal. It starts at a point on or near
     * the surface, or passes through it.
     *
     * @param reachMetres the greatest distance from the ray's origin to that point
     */
    private static Ray ray(SplittableRandom random, HeightField field, double reachMetres) {
        Vector3d at = surface(random, field);
        Vector3d path = direction(random);
        if (random.nextInt(3) == 0) {
            at.add(0, random.nextDouble(-2, 2), 0);
        }
        double back = random.nextInt(4) == 0 ? 0 : reachMetres * random.nextDouble();
        at.fma(path.length() > 0 ? -back / path.length() : 0, path);
        return new Ray(at.x, at.y, at.z, path.x, path.y, path.z);
    }

    /** Returns a ray from one side of the field to the other. */
    private static Ray across(SplittableRandom random, HeightField field) {
        Aabb all = field.bounds();
        double x = random.nextDouble(all.minX(), all.maxX());
        double y = random.nextDouble(all.minY(), all.maxY());
        return new Ray(x, y, all.minZ() - 1, random.nextDouble(-0.2, 0.2), -0.01 * random.nextDouble(), 1);
    }

    private static RoundedHull shape(SplittableRandom random) {
        return switch (random.nextInt(4)) {
            case 0 -> RoundedHull.sphere(random.nextDouble(0.01, 1));
            case 1 -> RoundedHull.capsule(Vec3.of(direction(random).mul(0.5)), 0.2);
            case 2 -> box(random);
            default -> RoundedHull.uprightCapsule(0.3, 1.8);
        };
    }

    private static RoundedHull box(SplittableRandom random) {
        double turn = random.nextInt(2) * random.nextDouble(Math.PI);
        double x = 0.5 * StrictMath.cos(turn);
        double z = 0.5 * StrictMath.sin(turn);
        return RoundedHull.box(new Vec3(x, 0, z), new Vec3(0, random.nextDouble(0.05, 1), 0), new Vec3(-z, 0, x));
    }

    /** Returns a place above the surface, in it or below it. */
    private static Vector3d place(SplittableRandom random, HeightField field) {
        return surface(random, field).add(0, random.nextDouble(-0.5, 4), 0);
    }

    /** Returns a displacement downwards, level or in any direction; sometimes zero. */
    private static Vector3d displacement(SplittableRandom random) {
        Vector3d path = direction(random);
        return path.mul(random.nextInt(10) == 0 ? 0 : StrictMath.pow(10, random.nextDouble(-3, 0.7)));
    }
}
