package nephele.engine.atmosphere;

/**
 * The optical depth from a height to the top of the air along a direction, tabulated in the coordinates of E. Bruneton
 * and F. Neyret, "Precomputed Atmospheric Scattering", 2008, section 4: by the distance to the horizon and the distance
 * to the top of the air. In both the depth is nearly linear.
 */
final class SunTransmittance {
    private static final int DIRECTIONS = 256;
    private static final int HEIGHTS = 64;
    private static final double PLANET = Air.PLANET_RADIUS_METRES;
    private static final double TOP = Air.TOP_RADIUS_METRES;
    private static final double HORIZON_OF_TOP = Math.sqrt((TOP - PLANET) * (TOP + PLANET));

    private final double[] depths = new double[DIRECTIONS * HEIGHTS * Air.CHANNELS];

    SunTransmittance(Air air) {
        AirIntegral integral = new AirIntegral(air, AirIntegral.COARSE);
        AirRay ray = new AirRay();
        double[] depth = new double[Air.CHANNELS];
        for (int j = 0; j < HEIGHTS; j++) {
            double toHorizon = HORIZON_OF_TOP * j / (HEIGHTS - 1);
            double radius = Math.sqrt(PLANET * PLANET + toHorizon * toHorizon);
            double height = toHorizon * toHorizon / (radius + PLANET);
            for (int i = 0; i < DIRECTIONS; i++) {
                ray.set(height, cosine(radius, toHorizon, i / (DIRECTIONS - 1.0)), 1, 0);
                integral.putDepth(ray, depth);
                System.arraycopy(depth, 0, depths, (j * DIRECTIONS + i) * Air.CHANNELS, Air.CHANNELS);
            }
        }
    }

    private static double cosine(double radius, double toHorizon, double fraction) {
        double nearest = TOP - radius;
        double distance = nearest + fraction * (toHorizon + HORIZON_OF_TOP - nearest);
        double square = (TOP - radius) * (TOP + radius) - distance * distance;
        // A table's ray must not end at the ground, which the last one touches.
        double horizon = -toHorizon / radius;
        return distance == 0 ? 1 : Math.max(horizon + 1e-12, Math.min(1, square / (2 * radius * distance)));
    }

    /**
     * Puts the optical depth of the air above, for each wavelength; nothing is hidden by the planet here.
     *
     * @param sunCosine between the zenith and the sun; below the horizon, its value at the horizon holds
     */
    void putDepth(double heightMetres, double sunCosine, double[] depth) {
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        double radius = PLANET + height;
        double toHorizon = Math.sqrt(height * (radius + PLANET));
        double along = radius * sunCosine;
        double distance = -along + Math.sqrt(Math.max(0, along * along + (TOP - radius) * (TOP + radius)));
        double nearest = TOP - radius;
        double range = toHorizon + HORIZON_OF_TOP - nearest;
        double x = Math.max(0, Math.min(1, (distance - nearest) / range)) * (DIRECTIONS - 1);
        double y = toHorizon / HORIZON_OF_TOP * (HEIGHTS - 1);
        int i = Math.min(DIRECTIONS - 2, (int) x);
        int j = Math.min(HEIGHTS - 2, (int) y);
        int at = (j * DIRECTIONS + i) * Air.CHANNELS;
        int above = at + DIRECTIONS * Air.CHANNELS;
        double u = x - i;
        double v = y - j;
        for (int c = 0; c < Air.CHANNELS; c++) {
            double low = depths[at + c] + u * (depths[at + Air.CHANNELS + c] - depths[at + c]);
            double high = depths[above + c] + u * (depths[above + Air.CHANNELS + c] - depths[above + c]);
            depth[c] = low + v * (high - low);
        }
    }
}
