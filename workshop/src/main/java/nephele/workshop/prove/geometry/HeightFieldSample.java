package nephele.workshop.prove.geometry;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.RoundedHull;
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import org.joml.Vector3d;

/** Height fields, with rays and shapes placed where rounding and equal distances decide. */
final class HeightFieldSample {
    private static final double FAR_METRES = 1e5;

    private HeightFieldSample() {}

    private enum Relief {
        FLAT,
        HILLS,
        TERRACES,
        SPIKES
    }

    /**
     * Returns fields of one cell to 128 x 128 cells, square or not, at the origin or 100 km away; smaller ones first.
     */
    static List<HeightField> small() {
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
    static HeightField large(int side) {
        return field(Relief.HILLS, 0, 1, side, side);
    }

    /** Returns a field as the ground of a level. */
    static StaticShape.HeightGrid grid(HeightField field) {
        var said = new Terrain(
                "ground", "none", Vec3.ZERO, new Terrain.Sides(1, 1), new Terrain.HeightRange(0, 1), List.of(), false);
        return new StaticShape.HeightGrid(0, said, field);
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
    static Ray ray(SplittableRandom random, HeightField field, double reachMetres) {
        Vector3d at = surface(random, field);
        Vector3d way = direction(random);
        if (random.nextInt(3) == 0) {
            at.add(0, random.nextDouble(-2, 2), 0);
        }
        double back = random.nextInt(4) == 0 ? 0 : reachMetres * random.nextDouble();
        at.fma(way.length() > 0 ? -back / way.length() : 0, way);
        return new Ray(at.x, at.y, at.z, way.x, way.y, way.z);
    }

    /** Returns a ray from one side of the field to the other. */
    static Ray across(SplittableRandom random, HeightField field) {
        Aabb all = field.bounds();
        double x = random.nextDouble(all.minX(), all.maxX());
        double y = random.nextDouble(all.minY(), all.maxY());
        return new Ray(x, y, all.minZ() - 1, random.nextDouble(-0.2, 0.2), -0.01 * random.nextDouble(), 1);
    }

    static RoundedHull shape(SplittableRandom random) {
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
    static Vector3d place(SplittableRandom random, HeightField field) {
        return surface(random, field).add(0, random.nextDouble(-0.5, 4), 0);
    }

    /** Returns a displacement downwards, level or in any direction; sometimes zero. */
    static Vector3d way(SplittableRandom random) {
        Vector3d way = direction(random);
        return way.mul(random.nextInt(10) == 0 ? 0 : StrictMath.pow(10, random.nextDouble(-3, 0.7)));
    }
}
