package nephele.engine.atmosphere;

import java.util.Arrays;

/**
 * Sunlight at places in the air: what the air lets pass of the part of the disc that the planet does not hide. Not for
 * several threads.
 */
final class Sunlight {
    private final SunTransmittance air;
    private final double radiusRadians;
    private final double[] depth = new double[Air.CHANNELS];
    private final double[] depthHigh = new double[Air.CHANNELS];

    /** @param radiusRadians of the disc; 0 for a point */
    Sunlight(SunTransmittance air, double radiusRadians) {
        this.air = air;
        this.radiusRadians = radiusRadians;
    }

    /**
     * Puts the fraction of the sun's irradiance that arrives on a plane perpendicular to the beam, for each wavelength.
     *
     * @param sunSine of the elevation of the sun's middle
     */
    void put(double heightMetres, double sunSine, double[] irradiance) {
        SunOverLimb disc = SunOverLimb.of(radiusRadians, heightMetres, sunSine);
        if (disc.fraction() == 0) {
            Arrays.fill(irradiance, 0);
            return;
        }
        air.putDepth(heightMetres, disc.lowSine(), depth);
        if (disc.lowSine() == disc.highSine()) {
            for (int c = 0; c < Air.CHANNELS; c++) {
                irradiance[c] = disc.fraction() * Math.exp(-depth[c]);
            }
            return;
        }
        air.putDepth(heightMetres, disc.highSine(), depthHigh);
        for (int c = 0; c < Air.CHANNELS; c++) {
            // The mean of two exponentials is that of the mean exponent times a hyperbolic cosine.
            double middle = Math.exp(-0.5 * (depth[c] + depthHigh[c]));
            irradiance[c] = disc.fraction() * middle * hyperbolicCosine(0.5 * (depth[c] - depthHigh[c]));
        }
    }

    private static double hyperbolicCosine(double x) {
        double square = x * x;
        return square < 0.01 ? 1 + square * (0.5 + square / 24) : Math.cosh(x);
    }

    /** Puts the fraction of the sun's irradiance that arrives on level ground at height 0, for each wavelength. */
    void putOnGround(double sunSine, double[] irradiance) {
        SunOverLimb disc = SunOverLimb.of(radiusRadians, 0, sunSine);
        air.putDepth(0, disc.lowSine(), depth);
        air.putDepth(0, disc.highSine(), depthHigh);
        for (int c = 0; c < Air.CHANNELS; c++) {
            irradiance[c] = disc.fraction()
                    * 0.5
                    * (disc.lowSine() * Math.exp(-depth[c]) + disc.highSine() * Math.exp(-depthHigh[c]));
        }
    }
}
