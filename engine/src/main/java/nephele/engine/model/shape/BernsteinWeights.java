package nephele.engine.model.shape;

/**
 * The cubic Bernstein polynomials at one parameter.
 *
 * @param value values of the four polynomials
 * @param slope their first derivatives
 */
record BernsteinWeights(double[] value, double[] slope) {
    /**
     * Evaluates at {@code part / parts} in integers up to the last division, so that mirrored parameters match bitwise.
     */
    static BernsteinWeights at(int part, int parts) {
        long t = part;
        long rest = parts - part;
        double cube = (double) parts * parts * parts;
        return new BernsteinWeights(
                new double[] {
                    rest * rest * rest / cube, 3 * t * rest * rest / cube, 3 * t * t * rest / cube, t * t * t / cube
                },
                slopes((double) part / parts));
    }

    static BernsteinWeights at(double t) {
        double rest = 1 - t;
        return new BernsteinWeights(
                new double[] {rest * rest * rest, 3 * t * rest * rest, 3 * t * t * rest, t * t * t}, slopes(t));
    }

    private static double[] slopes(double t) {
        double rest = 1 - t;
        return new double[] {-3 * rest * rest, 3 * rest * rest - 6 * t * rest, 6 * t * rest - 3 * t * t, 3 * t * t};
    }
}
