package nephele.engine.math;

/** On which side of a plane a point lies. */
public enum PlaneSide {
    BEHIND,
    ON,
    IN_FRONT;

    /** Relative to the size of what is sorted, at least that of one metre. */
    private static final double THICKNESS = 1e-5;

    /** Rounding of three products and three sums, relative to the sum of magnitudes: γ₄ and a little. */
    private static final double FILTER = 5 * 0x1p-53;

    /** With the plane taken as thick as rounding and modelling make it: {@code 10⁻⁵ · max(1, extent)} metres each way. */
    public static PlaneSide ofThick(Plane plane, Vec3 point, double extentMetres) {
        double thickness = THICKNESS * Math.max(1, extentMetres);
        double distance = plane.signedDistance(point);
        return distance > thickness ? IN_FRONT : distance < -thickness ? BEHIND : ON;
    }

    /**
     * The sign of n · p − distance for exactly these doubles, as real numbers. The rounded value decides where its error
     * bound allows; else the terms are added without error (Shewchuk 1997, "Adaptive Precision Floating-Point
     * Arithmetic", section 2.4). Products below 10⁻³⁰⁰ may be lost.
     */
    public static PlaneSide exactlyOf(Plane plane, double x, double y, double z) {
        double px = plane.nx() * x;
        double py = plane.ny() * y;
        double pz = plane.nz() * z;
        double sum = px + py + pz - plane.distance();
        double magnitude = Math.abs(px) + Math.abs(py) + Math.abs(pz) + Math.abs(plane.distance());
        if (Math.abs(sum) > FILTER * magnitude) {
            return ofSign(sum);
        }
        double[] terms = {
            px,
            Math.fma(plane.nx(), x, -px),
            py,
            Math.fma(plane.ny(), y, -py),
            pz,
            Math.fma(plane.nz(), z, -pz),
            -plane.distance()
        };
        return ofSign(leadingTerm(terms));
    }

    private static PlaneSide ofSign(double value) {
        return value > 0 ? IN_FRONT : value < 0 ? BEHIND : ON;
    }

    /** The largest of non-overlapping doubles with the same exact sum, which has the sum's sign (GROW-EXPANSION). */
    private static double leadingTerm(double[] terms) {
        double[] expansion = new double[terms.length];
        int size = 0;
        for (double term : terms) {
            double carry = term;
            for (int i = 0; i < size; i++) {
                double sum = carry + expansion[i];
                double virtual = sum - carry;
                expansion[i] = (carry - (sum - virtual)) + (expansion[i] - virtual);
                carry = sum;
            }
            expansion[size++] = carry;
        }
        for (int i = size - 1; i >= 0; i--) {
            if (expansion[i] != 0) {
                return expansion[i];
            }
        }
        return 0;
    }
}
