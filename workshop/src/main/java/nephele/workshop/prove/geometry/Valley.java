package nephele.workshop.prove.geometry;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** A random valley with steep hills around it: oblong cells, bumps of any size, sometimes far from the world's origin. */
final class Valley {
    private static final double RIM_METRES = 60;
    private static final double FAR_METRES = 1e4;

    private final HeightField field;
    private final CollisionWorld world;

    private Valley(HeightField field) {
        this.field = field;
        var said = new Terrain(
                "valley", "none", Vec3.ZERO, new Terrain.Sides(1, 1), new Terrain.HeightRange(0, 1), List.of(), false);
        world = CollisionWorld.of(
                new StaticShapes(List.of(), PlacedModels.NONE, List.of(new StaticShape.HeightGrid(0, said, field))));
    }

    static Valley of(long number) {
        SplittableRandom random = new SplittableRandom(number);
        int columns = random.nextInt(9, 65);
        int rows = random.nextInt(9, 65);
        double far = random.nextInt(4) == 0 ? FAR_METRES : 0;
        double bumps = StrictMath.pow(10, random.nextDouble(-3, 1.2));
        double roughness = random.nextDouble(0.05, 0.9);
        SeededNoise noise = new SeededNoise(random.nextInt());
        Vec3 origin = new Vec3(far, random.nextDouble(-50, 50), -far);
        return new Valley(HeightField.of(
                origin,
                random.nextDouble(0.3, 4),
                random.nextDouble(0.3, 4),
                columns,
                rows,
                (column, row) -> bumps * noise.at(roughness * column, roughness * row, 0.5)
                        + rim(column, columns)
                        + rim(row, rows)));
    }

    private static double rim(int at, int count) {
        double aside = Math.abs(2.0 * at / (count - 1) - 1);
        return RIM_METRES * aside * aside * aside * aside;
    }

    CollisionWorld world() {
        return world;
    }

    /** Returns the height of a point above the ground; infinity beside the terrain. */
    double above(double x, double y, double z) {
        double ground = HeightFieldSurface.y(field, x, z);
        return Double.isNaN(ground) ? Double.POSITIVE_INFINITY : y - ground;
    }

    /** Returns a random place at a height above the ground, metres. */
    Vec3 place(SplittableRandom random, double metres) {
        double x = field.x(0) + field.cellX() * field.cellColumns() * random.nextDouble(0.1, 0.9);
        double z = field.z(0) + field.cellZ() * field.cellRows() * random.nextDouble(0.1, 0.9);
        return new Vec3(x, HeightFieldSurface.y(field, x, z) + metres, z);
    }
}
