package nephele.engine.scene.impostor;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The hemisphere of directions above the horizon as a square (Cigolle et al. 2014, "A Survey of Efficient Representations
 * for Independent Unit Vectors", hemi-oct). Its border is the horizon. The twin of {@code impostor-views.glsl}.
 */
public final class HemiOctahedron {
    private HemiOctahedron() {}

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
