package nephele.engine.cloud;

import java.math.BigDecimal;
import java.math.MathContext;

/** Distances along a ray to altitudes around the planet, with 40 digits. */
public final class ExactSlant {
    private static final double PLANET_METRES = 6_360_000;
    private static final MathContext DIGITS = new MathContext(40);

    private ExactSlant() {}

    /**
     * Returns the distance to an altitude; the eye is below it, or above it and looks up.
     *
     * @param sine of the ray's elevation
     */
    public static double metres(double eye, double sine, double altitude) {
        BigDecimal here = BigDecimal.valueOf(PLANET_METRES).add(new BigDecimal(eye));
        BigDecimal there = BigDecimal.valueOf(PLANET_METRES).add(new BigDecimal(altitude));
        BigDecimal half = here.multiply(new BigDecimal(sine), DIGITS);
        BigDecimal constant = here.multiply(here, DIGITS).subtract(there.multiply(there, DIGITS), DIGITS);
        return half.multiply(half, DIGITS)
                .subtract(constant, DIGITS)
                .sqrt(DIGITS)
                .subtract(half, DIGITS)
                .doubleValue();
    }
}
