package nephele.engine.particle;

/** Sines and fades of particle laws: cheap, exact after any time, since phases are reduced in double precision. */
final class Waves {
    private Waves() {}

    /**
     * Returns sin(2π turns) within 1e-4, by the sine's odd polynomial after reduction to a quarter turn either way.
     *
     * @param turns finite, up to 1e12
     */
    static double sine(double turns) {
        double x = turns - Math.rint(turns);
        double folded = x > 0.25 ? 0.5 - x : x < -0.25 ? -0.5 - x : x;
        double t = 2 * Math.PI * folded;
        double s = t * t;
        return t * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362_880)))));
    }

    static double cosine(double turns) {
        return sine(turns + 0.25);
    }

    /** Returns 0 below {@code from}, 1 above {@code to}, and a smooth step between. */
    static double step(double from, double to, double x) {
        double t = Math.min(1, Math.max(0, (x - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }
}
