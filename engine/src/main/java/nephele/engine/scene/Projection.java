package nephele.engine.scene;

/**
 * A perspective projection that is valid for every input: values out of range are clamped and NaN is replaced by a
 * default, so that no matrix ever contains a NaN. The clip space is OpenGL's, z from −1 at near to 1 at far.
 *
 * @param verticalFovRadians full angle, 1° to 170°; 60° for NaN
 * @param aspect width / height, 10⁻³ to 10³; 1 for NaN
 * @param nearMetres 1 mm to 1000 km; 5 cm for NaN
 * @param farMetres at least {@code nearMetres · (1 + 10⁻³)}, or infinite; infinite for NaN
 */
public record Projection(double verticalFovRadians, double aspect, double nearMetres, double farMetres) {
    /** Limits and default of the field of view, radians. */
    private static final double MIN_FOV_RADIANS = StrictMath.toRadians(1);

    private static final double MAX_FOV_RADIANS = StrictMath.toRadians(170);
    private static final double DEFAULT_FOV_RADIANS = StrictMath.toRadians(60);
    private static final double MAX_ASPECT = 1e3;
    /** Limits and default of the near plane's distance, metres. */
    private static final double MIN_NEAR_METRES = 1e-3;

    private static final double MAX_NEAR_METRES = 1e6;
    private static final double DEFAULT_NEAR_METRES = 0.05;

    public Projection {
        verticalFovRadians = clamp(verticalFovRadians, MIN_FOV_RADIANS, MAX_FOV_RADIANS, DEFAULT_FOV_RADIANS);
        aspect = clamp(aspect, 1 / MAX_ASPECT, MAX_ASPECT, 1);
        nearMetres = clamp(nearMetres, MIN_NEAR_METRES, MAX_NEAR_METRES, DEFAULT_NEAR_METRES);
        double leastFar = nearMetres * (1 + 1e-3);
        farMetres = clamp(farMetres, leastFar, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** Makes the projection with the given angle between the picture's left and right borders. */
    public static Projection ofHorizontalFov(double horizontalFovRadians, double aspect, double near, double far) {
        double width = clamp(horizontalFovRadians, MIN_FOV_RADIANS, MAX_FOV_RADIANS, DEFAULT_FOV_RADIANS);
        double ratio = clamp(aspect, 1 / MAX_ASPECT, MAX_ASPECT, 1);
        return new Projection(2 * StrictMath.atan(StrictMath.tan(width / 2) / ratio), ratio, near, far);
    }

    private static double clamp(double value, double least, double greatest, double insteadOfNan) {
        return Double.isNaN(value) ? insteadOfNan : Math.max(least, Math.min(greatest, value));
    }

    /** Returns half the picture's height at distance 1. */
    public double tanHalfHeight() {
        return StrictMath.tan(verticalFovRadians / 2);
    }

    /** Returns half the picture's width at distance 1. */
    public double tanHalfWidth() {
        return tanHalfHeight() * aspect;
    }

    /** Returns the factor on view z in clip z. */
    public double depthScale() {
        return isInfinite() ? -1 : -(farMetres + nearMetres) / (farMetres - nearMetres);
    }

    /** Returns the constant term in clip z. */
    public double depthOffset() {
        return isInfinite() ? -2 * nearMetres : -2 * nearMetres * (farMetres / (farMetres - nearMetres));
    }

    private boolean isInfinite() {
        // Beyond this ratio far + near rounds to far; the limit of the matrix is then exact in float.
        return farMetres > 1e9 * nearMetres;
    }
}
