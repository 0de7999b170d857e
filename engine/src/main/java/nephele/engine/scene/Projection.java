package nephele.engine.scene;

/**
 * A perspective projection; OpenGL's clip space, z from −1 at near to 1 at far.
 *
 * @param verticalFovRadians full angle
 * @param aspect width / height
 */
public record Projection(double verticalFovRadians, double aspect, double nearMetres, double farMetres) {
    /** Half the picture's height at distance 1. */
    public double tanHalfHeight() {
        return Math.tan(verticalFovRadians / 2);
    }

    public double tanHalfWidth() {
        return tanHalfHeight() * aspect;
    }
}
