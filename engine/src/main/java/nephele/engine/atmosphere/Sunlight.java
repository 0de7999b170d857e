package nephele.engine.atmosphere;

/**
 * Sunlight at places in the air: what the air lets pass of the part of the disc that the planet does not hide. Not for
 * several threads.
 */
final class Sunlight {
    private final SunTransmittance air;
    private final double radiusRadians;
    private final double[] high = new double[Air.CHANNELS];

    /** @param radiusRadians of the disc; 0 for a point */
    Sunlight(SunTransmittance air, double radiusRadians) {
        this.air = air;
        this.radiusRadians = radiusRadians;
    }

    /**
     * Puts the share of the sun's irradiance that arrives on a plane perpendicular to the beam, for each wavelength.
     *
     * @param sunSine of the elevation of the sun's middle
     */
    void put(double heightMetres, double sunSine, double[] irradiance) {
        SunOverLimb disc = SunOverLimb.seen(radiusRadians, heightMetres, sunSine);
        air.put(heightMetres, disc.lowSine(), irradiance);
        if (disc.lowSine() != disc.highSine()) {
            air.put(heightMetres, disc.highSine(), high);
            for (int c = 0; c < Air.CHANNELS; c++) {
                irradiance[c] = 0.5 * (irradiance[c] + high[c]);
            }
        }
        for (int c = 0; c < Air.CHANNELS; c++) {
            irradiance[c] *= disc.share();
        }
    }

    /** Puts the share of the sun's irradiance that arrives on level ground at height 0, for each wavelength. */
    void putOnGround(double sunSine, double[] irradiance) {
        SunOverLimb disc = SunOverLimb.seen(radiusRadians, 0, sunSine);
        air.put(0, disc.lowSine(), irradiance);
        air.put(0, disc.highSine(), high);
        for (int c = 0; c < Air.CHANNELS; c++) {
            irradiance[c] = disc.share() * 0.5 * (disc.lowSine() * irradiance[c] + disc.highSine() * high[c]);
        }
    }
}
