package nephele.engine.level.appearance;

/**
 * The falloff of a punctual light with distance and towards the edge of its cone; the twin of {@code
 * light-falloff.glsl}.
 */
public final class LightFalloff {
    /** Squared distance below which the irradiance grows no further: a centimetre. */
    public static final double MIN_SQUARE_METRES = 1e-4;

    private LightFalloff() {}

    /**
     * Returns the inverse square under a window that is zero at the range (Karis 2013, "Real Shading in Unreal Engine
     * 4", section "Lighting model").
     *
     * @return 1/m²
     */
    public static double windowedInverseSquare(double squareDistance, double inverseSquareRange) {
        double q = squareDistance * inverseSquareRange;
        double window = Math.min(Math.max(1 - q * q, 0), 1);
        return window * window / Math.max(squareDistance, MIN_SQUARE_METRES);
    }

    /**
     * Returns 1 inside the inner cone, 0 outside the outer one, and the square of a linear ramp of the cosine between
     * them.
     */
    public static double cone(double cosineFromAxis, double scale, double offset) {
        double t = Math.min(Math.max(cosineFromAxis * scale + offset, 0), 1);
        return t * t;
    }
}
