package nephele.engine.atmosphere;

import java.util.Arrays;
import nephele.engine.math.GaussLegendre;
import nephele.engine.math.Vec3;

/**
 * The radiance of a clear sky and of the planet's ground by numerical integration: light scattered once by quadrature
 * along the ray, light scattered more often from the {@link LightField}. It is the reference of the {@link SkyTable}
 * that is drawn. Not for several threads.
 */
public final class ClearSky {
    /** Colours of {@link #put}: scattered once by molecules, once by aerosols, all other light. */
    static final int PARTS = 3;

    private static final int CHANNELS = Air.CHANNELS;

    private final AirTables tables;
    private final Sunlight sun;
    private final SingleScattering once;
    private final RepeatedScattering more;
    private final AirIntegral integral;
    private final AirIntegral integralMore;
    private final AirRay ray;
    private final double[] parts = new double[PARTS * CHANNELS];
    private final double[] single = new double[2 * CHANNELS];
    private final double[] multiple = new double[CHANNELS];
    private final double[] transmittance = new double[CHANNELS];
    private final double[] direct = new double[CHANNELS];
    private final double[] diffuse = new double[CHANNELS];

    public ClearSky(AirTables tables) {
        this(tables, AirIntegral.FINE, AirIntegral.FINE);
    }

    /**
     * @param ruleOnce for light scattered once, which changes fast at the edge of the shadow
     * @param ruleMore for light scattered more often
     */
    ClearSky(AirTables tables, GaussLegendre ruleOnce, GaussLegendre ruleMore) {
        this.tables = tables;
        ray = new AirRay(tables.air().shadowEdgeRadians(), 0);
        sun = tables.sunlight();
        once = new SingleScattering(tables.air(), sun);
        more = new RepeatedScattering(tables.air(), tables.field(), tables.mieMoments());
        integral = new AirIntegral(tables.air(), ruleOnce);
        integralMore = new AirIntegral(tables.air(), ruleMore);
    }

    /**
     * Returns the radiance without the sun's disc, per unit solar irradiance outside the air, 1/sr.
     *
     * @param heightMetres of the eye; outside 0 to {@link Air#TOP_METRES} that of the nearest of both
     * @param direction of the ray, unit, +y is the zenith
     * @param towardsSun unit
     */
    public Vec3 radiance(double heightMetres, Vec3 direction, Vec3 towardsSun) {
        double between = Math.max(-1, Math.min(1, direction.dot(towardsSun)));
        ray.set(Math.max(0, Math.min(Air.TOP_METRES, heightMetres)), direction.y(), towardsSun.y(), between);
        return radiance(ray);
    }

    /**
     * Returns what the air along a part of a ray does to light: it adds its own and lets a fraction pass. Neither the
     * planet's ground nor the sky behind the end counts. Below the ground the air is that of height 0.
     *
     * @param heightMetres of the beginning; outside 0 to {@link Air#TOP_METRES} that of the nearest of both
     * @param direction of the ray, unit, +y is the zenith of the beginning
     * @param towardsSun unit
     * @param lengthMetres of the part, at least 0
     */
    public AirLight along(double heightMetres, Vec3 direction, Vec3 towardsSun, double lengthMetres) {
        double between = Math.max(-1, Math.min(1, direction.dot(towardsSun)));
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        ray.setSegment(height, direction.y(), towardsSun.y(), between, lengthMetres);
        Vec3 radiance = radiance(ray);
        return new AirLight(radiance, new Vec3(transmittance[0], transmittance[1], transmittance[2]));
    }

    Vec3 radiance(AirRay along) {
        put(along, parts);
        double rayleigh = Air.rayleighPhase(along.betweenCosine());
        double mie = tables.air().miePhase(along.betweenCosine());
        double[] sum = new double[CHANNELS];
        for (int c = 0; c < CHANNELS; c++) {
            sum[c] = rayleigh * parts[c] + mie * parts[CHANNELS + c] + parts[2 * CHANNELS + c];
        }
        return new Vec3(sum[0], sum[1], sum[2]);
    }

    /** Puts the parts of the radiance; the phase functions are left to be multiplied to the first two. */
    void put(AirRay along, double[] radiance) {
        putMore(along, multiple);
        putOnce(along, radiance);
        for (int c = 0; c < CHANNELS; c++) {
            radiance[2 * CHANNELS + c] += multiple[c];
        }
    }

    /** Puts the light that the air scatters more than once. */
    void putMore(AirRay along, double[] radiance) {
        integralMore.put(along, more, radiance, transmittance);
    }

    /** Puts the parts of the radiance without the light that the air scatters more than once. */
    void putOnce(AirRay along, double[] radiance) {
        integral.put(along, once, single, transmittance);
        System.arraycopy(single, 0, radiance, 0, single.length);
        Arrays.fill(radiance, single.length, PARTS * CHANNELS, 0);
        if (along.hitsGround()) {
            addGround(along, radiance);
        }
    }

    private void addGround(AirRay along, double[] radiance) {
        along.lookAt(along.lengthMetres());
        double cosine = along.pointSunCosine();
        sun.putOnGround(cosine, direct);
        tables.field().putGroundIrradiance(cosine, diffuse);
        Vec3 albedo = tables.air().groundAlbedo();
        double[] reflected = {albedo.x(), albedo.y(), albedo.z()};
        for (int c = 0; c < CHANNELS; c++) {
            double irradiance = direct[c] + diffuse[c];
            radiance[2 * CHANNELS + c] += reflected[c] / Math.PI * transmittance[c] * irradiance;
        }
    }
}
