package nephele.engine.reference.sky;

import java.util.concurrent.atomic.AtomicReferenceArray;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyLattice;
import nephele.engine.atmosphere.SunOverLimb;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.DistantLight;

/**
 * Sun or moon over the planet. At a place there arrives what the air above lets pass, and as much of the disc as the planet
 * does not hide, as {@link Air#sunlight}. The air's transmittance is integrated at nodes of height and angle above the
 * horizon, when it is first needed; between them its logarithm is linear. Threads may share it.
 */
final class LightOverPlanet implements DistantLight {
    private static final int HEIGHTS = 513;
    private static final int NODES_PER_DEGREE = 20;
    private static final int MOST_DEGREES = 101;
    private static final double PLANET = Air.PLANET_RADIUS_METRES;
    private static final double LEAST_TRANSMITTANCE = 1e-300;

    private final Air air;
    private final Vec3 outside;
    private final Vec3 scattered;
    private final Vec3 towards;
    private final SkyLattice sky;
    /** For each angle above the horizon the logarithms for each height and wavelength. */
    private final AtomicReferenceArray<double[]> logarithms =
            new AtomicReferenceArray<>(MOST_DEGREES * NODES_PER_DEGREE + 1);

    /**
     * @param outside irradiance above the air, RGB
     * @param scattered the same for the light that the air scatters
     * @param towards unit
     */
    LightOverPlanet(AirTables tables, Vec3 outside, Vec3 scattered, Vec3 towards) {
        air = tables.air();
        this.outside = outside;
        this.scattered = scattered;
        this.towards = towards;
        sky = new SkyLattice(tables, towards.y());
    }

    /** Returns the radiance of its light that the air scatters, from a direction of a place. */
    Vec3 skylight(PlanetPlace place, Vec3 direction) {
        Vec3 radiance = sky.radiance(
                place.altitudeMetres(),
                place.zenith().dot(direction),
                place.zenith().dot(towards),
                direction.dot(towards));
        return radiance.times(scattered);
    }

    @Override
    public Vec3 towards() {
        return towards;
    }

    @Override
    public Vec3 irradiance(Vec3 at) {
        PlanetPlace place = PlanetPlace.of(at);
        double height = Math.max(0, Math.min(Air.TOP_METRES, place.altitudeMetres()));
        SunOverLimb disc =
                SunOverLimb.of(air.sunRadiusRadians(), height, place.zenith().dot(towards));
        if (disc.fraction() == 0) {
            return Vec3.ZERO;
        }
        Vec3 passed = passed(height, disc.lowSine())
                .plus(passed(height, disc.highSine()))
                .scaled(0.5 * disc.fraction());
        return outside.times(passed);
    }

    private Vec3 passed(double height, double sine) {
        double above = StrictMath.asin(Math.max(-1, Math.min(1, sine))) - horizonRadians(height);
        double x = Math.toDegrees(Math.max(0, above)) * NODES_PER_DEGREE;
        int column = Math.min(logarithms.length() - 2, (int) x);
        double y = Math.sqrt(height / Air.TOP_METRES) * (HEIGHTS - 1);
        int row = Math.min(HEIGHTS - 2, (int) y);
        double[] low = logarithms(column);
        double[] high = logarithms(column + 1);
        double[] passed = new double[3];
        for (int channel = 0; channel < 3; channel++) {
            double before = between(low, row, y - row, channel);
            passed[channel] = StrictMath.exp(before + (x - column) * (between(high, row, y - row, channel) - before));
        }
        return new Vec3(passed[0], passed[1], passed[2]);
    }

    private static double between(double[] column, int row, double fraction, int channel) {
        double low = column[3 * row + channel];
        return low + fraction * (column[3 * row + 3 + channel] - low);
    }

    /** Returns the elevation of the horizon, at most 0. */
    private static double horizonRadians(double height) {
        return -StrictMath.acos(PLANET / (PLANET + height));
    }

    private double[] logarithms(int column) {
        double[] known = logarithms.get(column);
        if (known == null) {
            known = integrated(Math.toRadians((double) column / NODES_PER_DEGREE));
            logarithms.set(column, known);
        }
        return known;
    }

    private double[] integrated(double aboveHorizon) {
        double[] logarithms = new double[3 * HEIGHTS];
        for (int row = 0; row < HEIGHTS; row++) {
            double fraction = row / (HEIGHTS - 1.0);
            double height = Air.TOP_METRES * fraction * fraction;
            double elevation = Math.min(Math.PI / 2, horizonRadians(height) + aboveHorizon);
            Vec3 passed = air.transmittance(height, StrictMath.sin(elevation));
            logarithms[3 * row] = StrictMath.log(Math.max(LEAST_TRANSMITTANCE, passed.x()));
            logarithms[3 * row + 1] = StrictMath.log(Math.max(LEAST_TRANSMITTANCE, passed.y()));
            logarithms[3 * row + 2] = StrictMath.log(Math.max(LEAST_TRANSMITTANCE, passed.z()));
        }
        return logarithms;
    }
}
