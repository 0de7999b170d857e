package nephele.engine.measure;

/** Narkowicz' fit of the ACES filmic curve (2015), at 0.6 of the exposure: the tone mapper of HDR-FLIP. */
final class DisplayToneCurve {
    private static final double EXPOSURE = 0.6;
    private static final double A2 = 2.51 * EXPOSURE * EXPOSURE;
    private static final double A1 = 0.03 * EXPOSURE;
    private static final double B2 = 2.43 * EXPOSURE * EXPOSURE;
    private static final double B1 = 0.59 * EXPOSURE;
    private static final double B0 = 0.14;

    private DisplayToneCurve() {}

    static double map(double radiance) {
        double mapped = radiance * (A2 * radiance + A1) / (radiance * (B2 * radiance + B1) + B0);
        return Math.min(Math.max(mapped, 0), 1);
    }

    /** Returns the greater radiance that is mapped to {@code shown}, which is below 1. */
    static double inverse(double shown) {
        double a = A2 - shown * B2;
        double b = A1 - shown * B1;
        double c = -shown * B0;
        return (-b + Math.sqrt(b * b - 4 * a * c)) / (2 * a);
    }
}
