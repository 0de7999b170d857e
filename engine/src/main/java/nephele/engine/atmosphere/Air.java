package nephele.engine.atmosphere;

import nephele.engine.math.Vec3;

/**
 * The gases and aerosols around the planet and the sun above them, for 680, 550 and 440 nm (red, green, blue): Rayleigh
 * scattering, Mie scattering and absorption, both falling exponentially with height, and a layer of ozone that absorbs. Constants: E.
 * Bruneton and F. Neyret, "Precomputed Atmospheric Scattering", 2008, section 4, with the ozone of E. Bruneton's
 * implementation of 2017.
 *
 * @param groundAlbedo of the planet, a Lambertian reflector
 * @param mieScale factor on the aerosols; 1 is clear air
 * @param mieG asymmetry of the aerosols' phase function, in (-1, 1)
 * @param ozoneScale factor on the ozone
 * @param sunRadiusRadians angular radius of the sun's disc; 0 is a point, whose shadow has a hard edge
 */
public record Air(Vec3 groundAlbedo, double mieScale, double mieG, double ozoneScale, double sunRadiusRadians) {
    public static final Air CLEAR = new Air(new Vec3(0.3, 0.3, 0.3), 1, 0.8, 1, SunOverLimb.RADIUS_RADIANS);

    public static final double PLANET_RADIUS_METRES = 6_360_000;
    public static final double TOP_METRES = 100_000;
    static final double TOP_RADIUS_METRES = PLANET_RADIUS_METRES + TOP_METRES;

    /** The number of wavelengths. */
    static final int CHANNELS = 3;

    private static final double[] RAYLEIGH_PER_METRE = {5.802e-6, 13.558e-6, 33.1e-6};
    private static final double MIE_SCATTERING_PER_METRE = 3.996e-6;
    private static final double MIE_ABSORPTION_PER_METRE = 0.444e-6;
    private static final double[] OZONE_PER_METRE = {0.650e-6, 1.881e-6, 0.085e-6};
    /** Height over which the molecules' density falls by a factor e. */
    static final double RAYLEIGH_HEIGHT_METRES = 8_000;

    private static final double MIE_HEIGHT_METRES = 1_200;
    private static final double OZONE_MIDDLE_METRES = 25_000;
    private static final double OZONE_HALF_WIDTH_METRES = 15_000;

    /** Heights between which a polynomial follows the extinction well; the ozone has kinks at three of them. */
    static final double[] LAYERS_METRES = {600, 2_000, 5_000, 10_000, 17_000, 25_000, 40_000, 65_000};

    /**
     * Half of the width of the edge of the planet's shadow in the air, as a fraction of the sun's radius. The whole disc
     * would blur the edge more than tables of a parallel beam allow (1 % of their radiance); with a point the sky jumps
     * when the edge sweeps the lowest air.
     */
    private static final double EDGE_FRACTION = 0.375;

    /** Returns the angular radius of the disc that lights the air. */
    double shadowEdgeRadians() {
        return EDGE_FRACTION * sunRadiusRadians;
    }

    /** Returns the same air under a sun of another angular radius. */
    public Air withSunRadius(double radians) {
        return new Air(groundAlbedo, mieScale, mieG, ozoneScale, radians);
    }

    /** Returns true if the light that is scattered more than once, which does not depend on the disc, is clear air's. */
    public boolean isClear() {
        return equals(CLEAR.withSunRadius(sunRadiusRadians));
    }

    /** Returns the scattering by molecules at the ground, per metre. */
    static double rayleighPerMetre(int channel) {
        return RAYLEIGH_PER_METRE[channel];
    }

    /** Returns the scattering by aerosols at the ground, per metre; it is the same for all wavelengths. */
    double miePerMetre() {
        return mieScale * MIE_SCATTERING_PER_METRE;
    }

    /** Returns the density of the molecules at a height of at least 0, relative to that at the ground. */
    static double molecules(double heightMetres) {
        return Math.exp(-heightMetres / RAYLEIGH_HEIGHT_METRES);
    }

    /** Returns the density of the aerosols at a height of at least 0, relative to that at the ground. */
    static double aerosols(double heightMetres) {
        return Math.exp(-heightMetres / MIE_HEIGHT_METRES);
    }

    /**
     * Puts the extinction of all constituents, per metre, for each wavelength.
     *
     * @param molecules relative density at this height
     * @param aerosols relative density at this height
     */
    void putExtinctionPerMetre(double heightMetres, double molecules, double aerosols, double[] extinction) {
        double mie = (1 + MIE_ABSORPTION_PER_METRE / MIE_SCATTERING_PER_METRE) * miePerMetre() * aerosols;
        double ozone =
                ozoneScale * Math.max(0, 1 - Math.abs(heightMetres - OZONE_MIDDLE_METRES) / OZONE_HALF_WIDTH_METRES);
        for (int c = 0; c < CHANNELS; c++) {
            extinction[c] = RAYLEIGH_PER_METRE[c] * molecules + mie + OZONE_PER_METRE[c] * ozone;
        }
    }

    /**
     * Returns the fraction of light that the air lets pass on its way from outside to a height.
     *
     * @param zenithCosine of the direction towards the light, which the planet must not hide
     */
    public Vec3 transmittance(double heightMetres, double zenithCosine) {
        AirRay ray = new AirRay();
        ray.set(heightMetres, zenithCosine, 1, zenithCosine);
        double[] depth = new double[CHANNELS];
        new AirIntegral(this, AirIntegral.FINE).putDepth(ray, depth);
        return new Vec3(Math.exp(-depth[0]), Math.exp(-depth[1]), Math.exp(-depth[2]));
    }

    /**
     * Returns the fraction of the sun's irradiance that reaches a plane perpendicular to its beam: what the air lets pass
     * of the part of the disc that the planet does not hide.
     *
     * @param sunSine of the elevation of the sun's middle
     */
    public Vec3 sunlight(double heightMetres, double sunSine) {
        SunOverLimb disc = SunOverLimb.of(sunRadiusRadians, heightMetres, sunSine);
        if (disc.fraction() == 0) {
            return Vec3.ZERO;
        }
        double horizon = Math.sin(SkyTable.horizonRadians(heightMetres)) + 1e-9;
        Vec3 low = transmittance(heightMetres, Math.max(horizon, disc.lowSine()));
        Vec3 high = transmittance(heightMetres, Math.max(horizon, disc.highSine()));
        return low.plus(high).scaled(0.5 * disc.fraction());
    }

    /** Returns the phase function of molecules, per steradian: Rayleigh's, without polarisation. */
    static double rayleighPhase(double cosine) {
        return 3 / (16 * Math.PI) * (1 + cosine * cosine);
    }

    /**
     * Returns the phase function of aerosols, per steradian: W. M. Cornette and J. G. Shanks, "Physically reasonable
     * analytic expression for the single-scattering phase function", 1992, equation 11.
     */
    double miePhase(double cosine) {
        double g2 = mieG * mieG;
        double from = (1 - mieG) * (1 - mieG) + 2 * mieG * (1 - cosine);
        return 3 / (8 * Math.PI) * (1 - g2) * (1 + cosine * cosine) / ((2 + g2) * from * Math.sqrt(from));
    }
}
