package nephele.engine.reference.sky;

import nephele.engine.atmosphere.Air;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The sun's irradiance at heights above the planet: what the air above lets pass, and as much of the disc as the planet
 * does not hide. At the ground and below it is {@link Daylight#onGround}. The air's transmittance is integrated at nodes,
 * between which its logarithm is linear in the square root of the height. Immutable.
 */
final class SunAtHeights {
    private static final int NODES = 1025;
    private static final double PLANET = Air.PLANET_RADIUS_METRES;
    private static final double LEAST_TRANSMITTANCE = 1e-300;

    private final Vec3 outside;
    private final double sine;
    /** The logarithm of the transmittance for each node and wavelength; {@code null} without air. */
    private final double[] logarithms;

    private SunAtHeights(Vec3 outside, double sine, double[] logarithms) {
        this.outside = outside;
        this.sine = sine;
        this.logarithms = logarithms;
    }

    /** @param environment with the sun of its hour */
    static SunAtHeights of(Environment environment) {
        Sun sun = environment.sun();
        if (sun == null) {
            return new SunAtHeights(Vec3.ZERO, 1, null);
        }
        double sine = Directions.unit(sun.directionTowardsSun()).y();
        double[] logarithms =
                environment.sky() instanceof Sky.Atmosphere sky ? logarithms(Daylight.air(sky), sine) : null;
        return new SunAtHeights(sun.irradiance(), sine, logarithms);
    }

    private static double[] logarithms(Air air, double sine) {
        double[] logarithms = new double[3 * NODES];
        for (int node = 0; node < NODES; node++) {
            double share = node / (NODES - 1.0);
            double height = Air.TOP_METRES * share * share;
            Vec3 passed = air.transmittance(height, Math.max(sine, horizonSine(height)));
            logarithms[3 * node] = Math.log(Math.max(LEAST_TRANSMITTANCE, passed.x()));
            logarithms[3 * node + 1] = Math.log(Math.max(LEAST_TRANSMITTANCE, passed.y()));
            logarithms[3 * node + 2] = Math.log(Math.max(LEAST_TRANSMITTANCE, passed.z()));
        }
        return logarithms;
    }

    /** Returns the sine of the elevation of the horizon, at most 0. */
    private static double horizonSine(double height) {
        return -Math.sqrt(height * (height + 2 * PLANET)) / (height + PLANET);
    }

    /** Returns the RGB irradiance on a plane perpendicular to the beam. */
    Vec3 at(double heightMetres) {
        if (logarithms == null) {
            return outside;
        }
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        double seen = Daylight.shareAboveHorizon(Math.asin(sine) - Math.asin(horizonSine(height)));
        if (seen == 0) {
            return Vec3.ZERO;
        }
        double place = Math.sqrt(height / Air.TOP_METRES) * (NODES - 1);
        int node = Math.min(NODES - 2, (int) place);
        return new Vec3(
                seen * outside.x() * passed(node, place - node, 0),
                seen * outside.y() * passed(node, place - node, 1),
                seen * outside.z() * passed(node, place - node, 2));
    }

    private double passed(int node, double share, int channel) {
        double low = logarithms[3 * node + channel];
        return Math.exp(low + share * (logarithms[3 * node + 3 + channel] - low));
    }
}
