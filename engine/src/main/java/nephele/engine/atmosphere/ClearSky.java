package nephele.engine.atmosphere;

import nephele.engine.math.Vec3;

/**
 * The radiance of a clear sky and of the planet's ground by numerical integration: light scattered once by quadrature
 * along the ray, light scattered more often from the {@link LightField}. It is the reference of the tables that are
 * drawn. Not for several threads; copies share the tables.
 */
public final class ClearSky {
    private final Air air;
    private final SunTransmittance sun;
    private final LightField field;
    private final SingleScattering once;
    private final RepeatedScattering more;
    private final AirIntegral integral;
    private final AirRay ray = new AirRay();
    private final double[] single = new double[2 * Air.CHANNELS];
    private final double[] multiple = new double[Air.CHANNELS];
    private final double[] transmittance = new double[Air.CHANNELS];
    private final double[] direct = new double[Air.CHANNELS];
    private final double[] diffuse = new double[Air.CHANNELS];

    /** Computes all orders of scattering, which takes seconds. */
    public ClearSky(Air air) {
        this(air, new SunTransmittance(air), null);
    }

    private ClearSky(Air air, SunTransmittance sun, LightField known) {
        this.air = air;
        this.sun = sun;
        field = known == null ? ScatteringOrders.sum(air, sun) : known;
        once = new SingleScattering(air, sun);
        more = new RepeatedScattering(air, field, RepeatedScattering.mieMoments(air, field.degree()));
        integral = new AirIntegral(air, AirIntegral.FINE);
    }

    /** Returns one for another thread. */
    public ClearSky copy() {
        return new ClearSky(air, sun, field);
    }

    /**
     * Returns the radiance without the sun's disc, per unit solar irradiance outside the air, 1/sr.
     *
     * @param heightMetres of the eye; outside 0 to {@link Air#TOP_METRES} that of the nearest of both
     * @param direction of the ray, unit, +y is the zenith
     * @param towardsSun unit
     */
    public Vec3 radiance(double heightMetres, Vec3 direction, Vec3 towardsSun) {
        ray.set(
                Math.max(0, Math.min(Air.TOP_METRES, heightMetres)),
                direction.y(),
                towardsSun.y(),
                Math.max(-1, Math.min(1, direction.dot(towardsSun))));
        return radiance();
    }

    Vec3 radiance(AirRay along) {
        double between = along.betweenCosine();
        integral.put(along, more, multiple, transmittance);
        integral.put(along, once, single, transmittance);
        double rayleigh = Air.rayleighPhase(between);
        double mie = air.miePhase(between);
        for (int c = 0; c < Air.CHANNELS; c++) {
            multiple[c] += rayleigh * single[c] + mie * single[Air.CHANNELS + c];
        }
        Vec3 scattered = new Vec3(multiple[0], multiple[1], multiple[2]);
        return along.hitsGround() ? scattered.plus(ground(along)) : scattered;
    }

    private Vec3 radiance() {
        return radiance(ray);
    }

    private Vec3 ground(AirRay along) {
        along.lookAt(along.lengthMetres());
        double cosine = along.pointSunCosine();
        sun.put(0, cosine, direct);
        field.putGroundIrradiance(cosine, diffuse);
        double[] light = new double[Air.CHANNELS];
        for (int c = 0; c < Air.CHANNELS; c++) {
            light[c] = transmittance[c] / Math.PI * (Math.max(0, cosine) * direct[c] + diffuse[c]);
        }
        Vec3 albedo = air.groundAlbedo();
        return new Vec3(albedo.x() * light[0], albedo.y() * light[1], albedo.z() * light[2]);
    }
}
