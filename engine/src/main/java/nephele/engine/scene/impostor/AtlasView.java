package nephele.engine.scene.impostor;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * A parallel projection of a kind along a direction. Its rectangle holds the upright cylinder around the kind.
 *
 * @param towards unit, from the kind to the viewer
 * @param right unit, horizontal
 * @param up unit
 * @param halfHeight of the rectangle, metres; its half width is that of the cylinder
 */
record AtlasView(Vec3 towards, Vec3 right, Vec3 up, double halfHeight) {
    private static final double STEEP = 1e-6;

    static AtlasView of(Vec3 towards, KindShape shape) {
        double flat = Math.hypot(towards.x(), towards.z());
        Vec3 right = flat < STEEP ? new Vec3(1, 0, 0) : new Vec3(towards.z() / flat, 0, -towards.x() / flat);
        double halfHeight = shape.halfHeight() * flat + shape.halfWidth() * Math.abs(towards.y());
        return new AtlasView(towards, right, towards.cross(right), halfHeight);
    }

    /** Returns the view at a place of the grid. */
    static AtlasView at(int column, int row, KindShape shape) {
        double step = 2.0 / (ImpostorAtlas.SIDE - 1);
        return of(direction(column * step - 1, row * step - 1), shape);
    }

    /** Returns the unit direction of a point of the square. @param u −1 to 1, {@code v} likewise */
    public static Vec3 direction(double u, double v) {
        double x = (u + v) / 2;
        double z = (u - v) / 2;
        return Directions.unit(new Vec3(x, Math.max(0, 1 - Math.abs(x) - Math.abs(z)), z));
    }

    /** Returns the square's u for a direction; those below the horizon have that of the horizon. */
    public static double u(Vec3 direction) {
        return (direction.x() + direction.z()) / sum(direction);
    }

    /** Returns the square's v for a direction. */
    public static double v(Vec3 direction) {
        return (direction.x() - direction.z()) / sum(direction);
    }

    private static double sum(Vec3 direction) {
        double sum = Math.abs(direction.x()) + Math.max(0, direction.y()) + Math.abs(direction.z());
        return Math.max(sum, 1e-12);
    }
}
