package nephele.engine.atmosphere;

/**
 * The part of the sun's disc that the planet's limb, a straight line at this size, leaves visible, and two elevations
 * that stand for it: a function that is quadratic in elevation has the same mean over both as over the visible part.
 *
 * @param fraction of the disc that is visible, 0–1
 * @param lowSine of the lower elevation
 * @param highSine of the upper elevation
 */
public record SunOverLimb(double fraction, double lowSine, double highSine) {
    /** The angular radius of the sun, which is also the moon's. */
    public static final double RADIUS_RADIANS = Math.toRadians(0.2666);

    private static final double PLANET = Air.PLANET_RADIUS_METRES;
    private static final SunOverLimb HIDDEN = new SunOverLimb(0, 0, 0);
    /** Higher up the light that passes the air is linear over the disc to some 1e-5. */
    private static final double HIGH_SINE = 0.35;

    private static final double LEAST_FRACTION = 1e-12;

    /** Returns what is visible of the sun from a height, where its middle has an elevation. */
    public static SunOverLimb of(double heightMetres, double sunSine) {
        return of(RADIUS_RADIANS, heightMetres, sunSine);
    }

    /**
     * Returns what is visible of a sun of any size.
     *
     * @param radiusRadians 0 for a point, which is visible if the planet does not hide it
     */
    public static SunOverLimb of(double radiusRadians, double heightMetres, double sunSine) {
        if (sunSine > HIGH_SINE) {
            return new SunOverLimb(1, sunSine, sunSine);
        }
        double sunCosine = Math.sqrt(Math.max(0, 1 - sunSine * sunSine));
        double toHorizon = Math.sqrt(heightMetres * (2 * PLANET + heightMetres));
        // The sine of the angle above the horizon, without inverse functions.
        double above = (sunSine * PLANET + sunCosine * toHorizon) / (PLANET + heightMetres);
        if (radiusRadians == 0) {
            return above < 0 ? HIDDEN : new SunOverLimb(1, sunSine, sunSine);
        }
        double d = above / radiusRadians;
        if (d >= 1) {
            double spread = 0.5 * radiusRadians * sunCosine;
            return new SunOverLimb(1, sunSine - spread, sunSine + spread);
        }
        return d <= -1 ? HIDDEN : cut(d, radiusRadians, sunSine, sunCosine);
    }

    /** @param d height of the middle above the limb, in radii, between -1 and 1 */
    private static SunOverLimb cut(double d, double radiusRadians, double sunSine, double sunCosine) {
        double half = Math.sqrt(Math.max(0, 1 - d * d));
        double angle = Math.asin(d);
        double fraction = 0.5 + (d * half + angle) / Math.PI;
        if (fraction < LEAST_FRACTION) {
            return HIDDEN;
        }
        // First and second moment of the circular segment about the middle of the disc.
        double mean = 2 / (3 * Math.PI) * half * half * half / fraction;
        double second = (0.125 + (angle - d * half * (1 - 2 * d * d)) / (4 * Math.PI)) / fraction;
        double spread = Math.sqrt(Math.max(0, second - mean * mean));
        double low = radiusRadians * (mean - spread);
        double high = radiusRadians * (mean + spread);
        return new SunOverLimb(fraction, sunSine + sunCosine * low, sunSine + sunCosine * high);
    }
}
