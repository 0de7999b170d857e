package nephele.engine.atmosphere;

import nephele.engine.math.Vec3;

/**
 * The light that the air scatters once towards an eye, up to several distances along a ray, by numerical integration: the
 * part of the air's light that clouds can shade. Not for several threads.
 */
public final class LightScatteredOnce {
    private static final int CHANNELS = Air.CHANNELS;

    private final Air air;
    private final AirIntegral integral;
    private final AirSource source;

    public LightScatteredOnce(AirTables tables) {
        air = tables.air();
        integral = new AirIntegral(air, AirIntegral.COARSE);
        source = SingleScattering.withPhases(tables);
    }

    /**
     * Returns the radiance per unit irradiance of the light outside the air, for each distance.
     *
     * @param heightMetres of the eye; outside 0 to {@link Air#TOP_METRES} that of the nearest of both
     * @param direction of the ray, unit, +y is the zenith of the eye
     * @param towardsLight unit
     * @param distances increasing, metres
     */
    public Vec3[] upTo(double heightMetres, Vec3 direction, Vec3 towardsLight, double[] distances) {
        double between = Math.max(-1, Math.min(1, direction.dot(towardsLight)));
        AirRay ray = new AirRay(air.shadowEdgeRadians(), distances.length);
        ray.setSegment(inAir(heightMetres), direction.y(), towardsLight.y(), between, distances);
        double[] light = new double[2 * CHANNELS * distances.length];
        integral.putParts(ray, source, distances, light);
        Vec3[] radiances = new Vec3[distances.length];
        for (int i = 0; i < distances.length; i++) {
            int at = 2 * CHANNELS * i;
            radiances[i] = new Vec3(light[at], light[at + 1], light[at + 2]);
        }
        return radiances;
    }

    /** Returns the distance at which a ray leaves the air or meets the planet's ground. */
    public static double metresToEnd(double heightMetres, double zenithCosine) {
        AirRay ray = new AirRay();
        ray.set(inAir(heightMetres), zenithCosine, 1, zenithCosine);
        return ray.lengthMetres();
    }

    private static double inAir(double heightMetres) {
        return Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
    }
}
