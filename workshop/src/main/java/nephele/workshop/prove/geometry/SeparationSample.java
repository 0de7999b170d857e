package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.RoundedHull;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * A moving shape and a solid, placed where rounding decides.
 *
 * @param halves half edges of the core: one of a segment (zero for a point), three of a box
 * @param radiusMetres by which the core is inflated; 0 for boxes
 * @param at origin of the shape
 */
record SeparationSample(List<Vector3d> halves, double radiusMetres, Vector3d at, ConvexPolyhedron solid) {
    private static final double[] SIZES = {1e-2, 1, 1, 1, 1e3};

    /** Returns random, touching, parallel, degenerate, tiny and huge pairs. */
    static SeparationSample of(long unit) {
        var random = new SplittableRandom(unit);
        double size = SIZES[random.nextInt(SIZES.length)];
        ConvexPolyhedron solid = solid(random, size);
        var face = solid.faces().get(random.nextInt(solid.faces().size()));
        Vector3d corner = face.polygon().get(0).toVector();
        Vector3d edge = face.polygon().get(1).toVector().sub(corner);
        List<Vector3d> halves = halves(random, size, edge);
        double radius = halves.size() == 1 ? radius(random, size) : 0;
        Vector3d at = new Vector3d();
        if (random.nextInt(4) == 0) {
            at.set(point(random, 3 * size));
        } else {
            // A corner, edge or face of the core is on one of the solid, or slightly off it.
            halves.forEach(half -> at.fma(random.nextInt(-1, 2), half));
            at.add(corner).fma(random.nextInt(3) == 0 ? 0 : random.nextDouble(), edge);
            Vector3d away =
                    switch (random.nextInt(3)) {
                        case 0 -> face.plane().normal().toVector();
                        case 1 -> direction(random);
                        default ->
                            at.equals(corner)
                                    ? direction(random)
                                    : new Vector3d(at).sub(corner).normalize();
                    };
            at.fma(nothingOrTiny(random) * size + radius, away);
        }
        return new SeparationSample(halves, radius, at, solid);
    }

    private static double nothingOrTiny(SplittableRandom random) {
        return random.nextInt(3) == 0 ? 0 : (random.nextInt(3) - 1) * StrictMath.pow(10, -16 * random.nextDouble());
    }

    private static double radius(SplittableRandom random, double size) {
        return random.nextBoolean() ? 0 : size * StrictMath.pow(10, random.nextDouble(-9, 1));
    }

    private static List<Vector3d> halves(SplittableRandom random, double size, Vector3d edge) {
        return switch (random.nextInt(9)) {
            case 0 -> List.of(new Vector3d());
            case 1 -> List.of(point(random, size));
            case 2 -> List.of(new Vector3d(edge).mul(0.5));
            case 3 -> List.of(new Vector3d(edge).mul(1000));
            case 4 -> List.of(new Vector3d(edge).mul(StrictMath.pow(10, -16 * random.nextDouble())));
            case 5 -> List.of(point(random, size * StrictMath.pow(10, -14 * random.nextDouble())));
            case 6 -> box(new Vector3d(size / 2, 0, 0), new Vector3d(0, size / 3, 0), size);
            case 7 -> box(direction(random).mul(size * random.nextDouble(0.01, 1)), direction(random), size);
            default -> box(new Vector3d(edge).mul(0.5), direction(random), size);
        };
    }

    /**
     * Returns half edges at right angles: along the first vector, across it in the plane of the second, and normal to
     * both.
     */
    private static List<Vector3d> box(Vector3d along, Vector3d towards, double size) {
        Vector3d unit = new Vector3d(along).normalize();
        Vector3d across = new Vector3d(towards).fma(-towards.dot(unit), unit);
        if (across.length() < 1e-3 * towards.length()) {
            across.set(unit.y, unit.z, unit.x).fma(-across.dot(unit), unit);
        }
        across.normalize(size / 3);
        return List.of(along, across, new Vector3d(unit).cross(across).mul(0.5));
    }

    private static ConvexPolyhedron solid(SplittableRandom random, double size) {
        return switch (random.nextInt(4)) {
            case 0 -> block(side(random, size), side(random, size), side(random, size));
            case 1 -> block(size * 0.003, 4 * size, 0.01 * size);
            case 2 -> block(6 * size, size * 0.003, 6 * size);
            default -> cut(random, size);
        };
    }

    private static double side(SplittableRandom random, double size) {
        return size * random.nextDouble(0.05, 4);
    }

    private static ConvexPolyhedron block(double x, double y, double z) {
        return ConvexPolyhedron.box(Aabb.around(Vec3.ZERO, new Vec3(x, y, z)));
    }

    private static ConvexPolyhedron cut(SplittableRandom random, double size) {
        List<Plane> planes = new ArrayList<>();
        block(side(random, size), side(random, size), side(random, size))
                .faces()
                .forEach(f -> planes.add(f.plane()));
        for (int i = random.nextInt(1, 6); i > 0; i--) {
            Vector3d normal = direction(random);
            planes.add(new Plane(normal.x, normal.y, normal.z, size * random.nextDouble(0.02, 1)));
        }
        return ConvexPolyhedron.fromPlanes(planes);
    }

    private static Vector3d direction(SplittableRandom random) {
        Vector3d v = point(random, 1);
        return v.lengthSquared() > 0.01 && v.lengthSquared() <= 1 ? v.normalize() : direction(random);
    }

    private static Vector3d point(SplittableRandom random, double reach) {
        return new Vector3d(
                random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), random.nextDouble(-reach, reach));
    }

    RoundedHull hull() {
        return halves.size() == 1
                ? RoundedHull.capsule(half(0), radiusMetres)
                : RoundedHull.box(half(0), half(1), half(2));
    }

    private Vec3 half(int i) {
        return new Vec3(halves.get(i).x, halves.get(i).y, halves.get(i).z);
    }

    /** Returns a face normal of a box core, or else of the solid. */
    Vector3d faceNormal(long unit) {
        if (halves.size() == 3) {
            return new Vector3d(halves.get((int) (unit % 3))).normalize(unit % 2 == 0 ? 1 : -1);
        }
        return solid.faces()
                .get((int) (unit % solid.faces().size()))
                .plane()
                .normal()
                .toVector();
    }

    /**
     * Returns the extent in metres of everything that is added and subtracted: core, solid, radius, the distance
     * between them.
     */
    double extentMetres() {
        double extent = radiusMetres + at.length();
        for (Vector3d half : halves) {
            extent += 2 * half.length();
        }
        Aabb b = solid.bounds();
        return extent + new Vector3d(b.maxX() - b.minX(), b.maxY() - b.minY(), b.maxZ() - b.minZ()).length();
    }

    /**
     * Returns the distance in metres between core and solid by {@link BruteForce}, with the shape moved by
     * {@code shift}; 0 if they intersect.
     */
    double distance(Vector3d shift) {
        Vector3d origin = new Vector3d(at).add(shift);
        if (halves.size() == 1) {
            Vector3d half = halves.get(0);
            return BruteForce.distance(new Vector3d(origin).sub(half), new Vector3d(origin).add(half), solid);
        }
        ConvexPolyhedron core = core(origin);
        return Math.min(edges(core, solid), edges(solid, core));
    }

    /** Returns the distance of two solids as the least distance of an edge of one from the other. */
    private static double edges(ConvexPolyhedron of, ConvexPolyhedron to) {
        double least = Double.POSITIVE_INFINITY;
        for (ConvexPolyhedron.Face face : of.faces()) {
            List<Vec3> ring = face.polygon();
            for (int i = 0; i < ring.size() && least > 0; i++) {
                Vector3d end = ring.get((i + 1) % ring.size()).toVector();
                least = Math.min(least, BruteForce.distance(ring.get(i).toVector(), end, to));
            }
        }
        return least;
    }

    private ConvexPolyhedron core(Vector3d origin) {
        List<Plane> planes = new ArrayList<>();
        for (Vector3d half : halves) {
            Vector3d n = new Vector3d(half).normalize();
            planes.add(new Plane(n.x, n.y, n.z, n.dot(origin) + half.length()));
            planes.add(new Plane(-n.x, -n.y, -n.z, -n.dot(origin) + half.length()));
        }
        return ConvexPolyhedron.fromPlanes(planes);
    }
}
