package nephele.engine.atmosphere;

/**
 * Where directions lie between the rows of a {@link SkyLattice}. The rows of the sky are densest at the horizon. Those of
 * the ground divide the distance to it, between which and the horizon light is smooth; they are densest at the nadir.
 *
 * @param isSky false if the direction meets the ground
 * @param place between the rows of the sky or of the ground, the first of which are the horizon and the nadir
 */
record LatticeRow(boolean isSky, double place) {
    static final int SKY = 49;
    static final int GROUND = 17;

    private static final double PLANET = Air.PLANET_RADIUS_METRES;
    private static final int GROUND_POWER = 3;

    /** Elevation of the first row above the horizon, so that it does not meet the ground. */
    private static final double LEAST_RADIANS = 1e-7;

    /** Returns the place of a direction as seen from a height. */
    static LatticeRow of(double height, double sine) {
        double r = PLANET + height;
        double along = r * sine;
        double square = along * along - toHorizonSquared(height);
        if (sine < 0 && square >= 0) {
            double distance = toHorizonSquared(height) / (Math.sqrt(square) - along);
            double range = Math.sqrt(toHorizonSquared(height)) - height;
            double fraction = range > 0 ? Math.max(0, Math.min(1, (distance - height) / range)) : 0;
            return new LatticeRow(false, Math.cbrt(fraction) * (GROUND - 1));
        }
        double horizon = horizonRadians(height);
        double above = Math.asin(Math.max(-1, Math.min(1, sine))) - horizon;
        double fraction = Math.max(0, Math.min(1, above / (Math.PI / 2 - horizon)));
        return new LatticeRow(true, Math.sqrt(fraction) * (SKY - 1));
    }

    private static double toHorizonSquared(double height) {
        return height * (height + 2 * PLANET);
    }

    private static double horizonRadians(double height) {
        return -Math.acos(PLANET / (PLANET + height));
    }

    /** Returns the sine of the elevation of a row of the sky. */
    static double skySine(double height, int row) {
        double horizon = horizonRadians(height);
        double fraction = row / (SKY - 1.0);
        return Math.sin(horizon + Math.max(LEAST_RADIANS, (Math.PI / 2 - horizon) * fraction * fraction));
    }

    /** Returns the sine of the elevation of a row of the ground; from height 0 all of it looks the same. */
    static double groundSine(double height, int row) {
        double fraction = row / (GROUND - 1.0);
        double range = Math.sqrt(toHorizonSquared(height)) - height;
        double distance = height + range * Math.pow(fraction, GROUND_POWER);
        double sine = -(distance * distance + toHorizonSquared(height)) / (2 * (PLANET + height) * distance);
        return height == 0 ? -1 : Math.max(-1, sine * (1 + 1e-12));
    }

    /** Returns the number of rows of its part. */
    int rows() {
        return isSky ? SKY : GROUND;
    }
}
