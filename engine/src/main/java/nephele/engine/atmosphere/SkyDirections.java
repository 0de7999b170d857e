package nephele.engine.atmosphere;

import nephele.engine.math.GaussLegendre;

/**
 * Directions over the sphere at a height with their weights, for integrals of light in the air. They are densest on both
 * sides of the horizon, where the light changes fastest.
 */
final class SkyDirections {
    private static final GaussLegendre UP = new GaussLegendre(14);
    private static final GaussLegendre DOWN = new GaussLegendre(8);

    private final int azimuths;
    final double[] cosines;
    final double[] azimuthCosines;
    /** Steradians; a direction stands for its mirror image at the plane through zenith and sun too. */
    final double[] weights;
    /** The harmonics of each direction. */
    final double[][] harmonics;

    /** @param azimuths from the sun to the direction opposite of it */
    SkyDirections(double heightMetres, int degree, int azimuths) {
        this.azimuths = azimuths;
        int count = (UP.nodes.length + DOWN.nodes.length) * azimuths;
        cosines = new double[count];
        azimuthCosines = new double[count];
        weights = new double[count];
        harmonics = new double[count][DirectionMoments.count(degree)];
        double ratio = Air.PLANET_RADIUS_METRES / (Air.PLANET_RADIUS_METRES + heightMetres);
        double horizon = -Math.sqrt(Math.max(0, (1 - ratio) * (1 + ratio)));
        int next = addHalf(0, UP, horizon, 1);
        addHalf(next, DOWN, horizon, -1);
        DirectionMoments moments = new DirectionMoments(degree);
        for (int i = 0; i < count; i++) {
            moments.put(cosines[i], azimuthCosines[i], harmonics[i]);
        }
    }

    private int addHalf(int first, GaussLegendre rule, double horizon, double end) {
        int next = first;
        for (int k = 0; k < rule.nodes.length; k++) {
            double u = rule.nodes[k];
            for (int a = 0; a < azimuths; a++) {
                cosines[next] = horizon + (end - horizon) * u * u;
                azimuthCosines[next] = Math.cos(Math.PI * (a + 0.5) / azimuths);
                weights[next] = rule.weights[k] * 2 * u * Math.abs(end - horizon) * 2 * Math.PI / azimuths;
                next++;
            }
        }
        return next;
    }

    int count() {
        return cosines.length;
    }
}
