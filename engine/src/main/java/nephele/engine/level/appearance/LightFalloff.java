package nephele.engine.level.appearance;

/** How a lamp's light thins out with distance and towards the rim of its cone; the twin of {@code lamp-falloff.glsl}. */
public final class LightFalloff {
    /** Nearer than a centimetre the light grows no further. */
    public static final double MIN_SQUARE_METRES = 1e-4;

    private LightFalloff() {}

    /**
     * Inverse square under a window that reaches zero at the range (Karis 2013, "Real Shading in Unreal Engine 4",
     * section "Lighting model").
     *
     * @return 1/m²
     */
    public static double windowedInverseSquare(double squareDistance, double inverseSquareRange) {
        double q = squareDistance * inverseSquareRange;
        double window = Math.min(Math.max(1 - q * q, 0), 1);
        return window * window / Math.max(squareDistance, MIN_SQUARE_METRES);
    }

    /** 1 inside the inner cone, 0 outside the outer one, square of a linear ramp over the cosine between them. */
    public static double cone(double cosineFromAxis, double scale, double offset) {
        double t = Math.min(Math.max(cosineFromAxis * scale + offset, 0), 1);
        return t * t;
    }
}
