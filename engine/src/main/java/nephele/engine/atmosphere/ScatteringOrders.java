package nephele.engine.atmosphere;

import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.math.GaussLegendre;

/**
 * Computes the light field in the air order by order of scattering: the light of each order is scattered once more, by
 * the air and by the ground, until an order adds little anywhere. The orders left out fall as the last two did.
 */
final class ScatteringOrders {
    /** Degree of the moments of light scattered once, whose aureole is narrow, and of light scattered more often. */
    static final int FIRST_DEGREE = 10;

    private static final int DEGREE = 4;
    private static final double DARK = 1e-12;
    /** Greatest ratio of two successive orders by which the rest is estimated. */
    private static final double MOST_RATIO = 0.9;

    private static final int MOST_ORDERS = 40;

    private final Air air;
    private final SunTransmittance sun;
    private final Accuracy accuracy;
    private final double[] mieMoments;
    private final double[][] sums;
    /** What the last order added, and the one before it. */
    private double[][] last;

    private double[][] lastButOne;
    private final double[] groundSums = new double[LightField.SUNS * Air.CHANNELS];
    private double[] groundLast;
    private double[] groundLastButOne;
    private double fraction;

    /** How exactly fields are computed. */
    enum Accuracy {
        /** An error of a thousandth: the field that the program carries. */
        FINE(1e-3, 8, AirIntegral.COARSE, AirIntegral.COARSE),
        /** Within 0.3 % of the other in a fourth of its time: fields for which somebody waits. */
        QUICK(0.06, 6, AirIntegral.SHORT, AirIntegral.SHORTEST);

        /** Fraction of the sum that an order adds at most if it is the last. */
        private final double leastFraction;
        /** Azimuths of light that is scattered more than twice. */
        private final int azimuths;

        private final GaussLegendre second;
        private final GaussLegendre later;

        Accuracy(double leastFraction, int azimuths, GaussLegendre second, GaussLegendre later) {
            this.leastFraction = leastFraction;
            this.azimuths = azimuths;
            this.second = second;
            this.later = later;
        }

        private GaussLegendre rule(LightField before) {
            return isOnce(before) ? second : later;
        }

        private int azimuths(LightField before) {
            return before == null ? 16 : isOnce(before) ? 8 : azimuths;
        }

        /** Returns true for light that is scattered once, whose aureole is narrow. */
        private static boolean isOnce(LightField before) {
            return before.degree() == FIRST_DEGREE;
        }
    }

    private ScatteringOrders(Air air, SunTransmittance sun, Accuracy accuracy) {
        this.air = air;
        this.accuracy = accuracy;
        this.sun = sun;
        mieMoments = RepeatedScattering.mieMoments(air, FIRST_DEGREE);
        sums = new double[LightField.HEIGHTS * LightField.SUNS * Air.CHANNELS][DirectionMoments.count(FIRST_DEGREE)];
    }

    /**
     * Returns the field of all orders: light scattered at least once, or reflected by the ground.
     *
     * @param progress the completed fraction, estimated from the light that the last order added
     */
    static LightField sum(Air air, SunTransmittance sun, Accuracy accuracy, DoubleConsumer progress) {
        progress.accept(0);
        ScatteringOrders orders = new ScatteringOrders(air, sun, accuracy);
        LightField last = orders.next(null, FIRST_DEGREE);
        for (int order = 2; order <= MOST_ORDERS && orders.fraction > accuracy.leastFraction; order++) {
            progress.accept(Math.max(0, Math.log(orders.fraction) / Math.log(accuracy.leastFraction)));
            last = orders.next(last.refined(), DEGREE);
        }
        if (accuracy == Accuracy.QUICK) {
            orders.addRest();
        }
        progress.accept(1);
        return orders.total();
    }

    /** Adds the orders that are left out, as a geometric series. */
    private void addRest() {
        for (int node = 0; node < sums.length; node++) {
            double ratio = lastButOne[node][0] > 0 ? last[node][0] / lastButOne[node][0] : 0;
            double rest = factor(ratio);
            for (int k = 0; k < last[node].length; k++) {
                sums[node][k] += rest * last[node][k];
            }
        }
        for (int node = 0; node < groundSums.length; node++) {
            double ratio = groundLastButOne[node] > 0 ? groundLast[node] / groundLastButOne[node] : 0;
            groundSums[node] += factor(ratio) * groundLast[node];
        }
    }

    private static double factor(double ratio) {
        double falling = Math.min(MOST_RATIO, ratio);
        return falling / (1 - falling);
    }

    private LightField next(LightField before, int degree) {
        LightField now = new LightField(degree);
        lastButOne = last;
        last = new double[sums.length][];
        groundLastButOne = groundLast;
        groundLast = new double[groundSums.length];
        double[] fractions = new double[LightField.HEIGHTS];
        IntStream.range(0, LightField.HEIGHTS).parallel().forEach(height -> {
            SkyDirections directions =
                    new SkyDirections(LightField.heightMetres(height), degree, accuracy.azimuths(before));
            Order order = before == null
                    ? new Order(air, sun)
                    : new Order(air, sun, before, mieMoments, accuracy.rule(before));
            for (int i = 0; i < LightField.SUNS; i++) {
                put(order, directions, height, i);
            }
            fractions[height] = add(height, now);
        });
        fraction = IntStream.range(0, fractions.length)
                .mapToDouble(j -> fractions[j])
                .max()
                .orElse(0);
        return now;
    }

    private static int node(int height, int sun, int channel) {
        return (height * LightField.SUNS + sun) * Air.CHANNELS + channel;
    }

    /** Computes a node of the present order. */
    private void put(Order order, SkyDirections directions, int height, int i) {
        double sunCosine = LightField.sunCosine(i);
        double[][] moments = new double[Air.CHANNELS][directions.harmonics[0].length];
        double[] radiance = new double[Air.CHANNELS];
        double[] irradiance = new double[Air.CHANNELS];
        for (int d = 0; d < directions.count(); d++) {
            order.put(LightField.heightMetres(height), sunCosine, directions, d, radiance);
            double[] harmonics = directions.harmonics[d];
            for (int c = 0; c < Air.CHANNELS; c++) {
                double weight = directions.weights[d] * radiance[c];
                irradiance[c] += Math.max(0, directions.cosines[d]) * weight;
                for (int k = 0; k < harmonics.length; k++) {
                    moments[c][k] += weight * harmonics[k];
                }
            }
        }
        for (int c = 0; c < Air.CHANNELS; c++) {
            last[node(height, i, c)] = moments[c];
            if (height == 0) {
                groundLast[node(0, i, c)] = irradiance[c];
            }
        }
    }

    /** Adds the present order at a height to the sums and puts it into a field; returns the greatest fraction that it adds. */
    private double add(int height, LightField field) {
        double most = 0;
        for (int i = 0; i < LightField.SUNS; i++) {
            for (int c = 0; c < Air.CHANNELS; c++) {
                int node = node(height, i, c);
                double[] moments = last[node];
                field.set(height, i, c, moments);
                double[] sum = sums[node];
                for (int k = 0; k < moments.length; k++) {
                    sum[k] += moments[k];
                }
                most = Math.max(most, sum[0] > DARK ? moments[0] / sum[0] : 0);
                if (height == 0) {
                    field.setGroundIrradiance(i, c, groundLast[node]);
                    groundSums[node] += groundLast[node];
                }
            }
        }
        return most;
    }

    private LightField total() {
        LightField total = new LightField(FIRST_DEGREE);
        for (int height = 0; height < LightField.HEIGHTS; height++) {
            for (int i = 0; i < LightField.SUNS; i++) {
                for (int c = 0; c < Air.CHANNELS; c++) {
                    total.set(height, i, c, sums[node(height, i, c)]);
                    total.setGroundIrradiance(i, c, groundSums[node(0, i, c)]);
                }
            }
        }
        return total;
    }

    /** Light of one order along rays. Not for several threads. */
    private static final class Order {
        private final Air air;
        private final Sunlight sun;
        private final LightField before;
        private final AirSource source;
        private final AirIntegral integral;
        private final AirRay ray = new AirRay();
        private final double[] light = new double[2 * Air.CHANNELS];
        private final double[] transmittance = new double[Air.CHANNELS];
        private final double[] atGround = new double[Air.CHANNELS];

        /** The first order. */
        Order(Air air, SunTransmittance sun) {
            this.air = air;
            this.sun = new Sunlight(sun, 0);
            before = null;
            source = new SingleScattering(air, this.sun);
            integral = new AirIntegral(air, AirIntegral.COARSE);
        }

        /** The order after that of a field. */
        Order(Air air, SunTransmittance sun, LightField before, double[] mieMoments, GaussLegendre rule) {
            this.air = air;
            this.sun = new Sunlight(sun, 0);
            this.before = before;
            source = new RepeatedScattering(air, before, mieMoments);
            integral = new AirIntegral(air, rule);
        }

        void put(double heightMetres, double sunCosine, SkyDirections directions, int d, double[] radiance) {
            double mu = directions.cosines[d];
            double between = mu * sunCosine
                    + Math.sqrt((1 - mu * mu) * (1 - sunCosine * sunCosine)) * directions.azimuthCosines[d];
            ray.set(heightMetres, mu, sunCosine, between);
            integral.put(ray, source, light, transmittance);
            double rayleigh = before == null ? Air.rayleighPhase(between) : 1;
            double mie = before == null ? air.miePhase(between) : 0;
            for (int c = 0; c < Air.CHANNELS; c++) {
                radiance[c] = rayleigh * light[c] + (before == null ? mie * light[Air.CHANNELS + c] : 0);
            }
            if (ray.hitsGround()) {
                addGround(radiance);
            }
        }

        private void addGround(double[] radiance) {
            ray.lookAt(ray.lengthMetres());
            double cosine = ray.pointSunCosine();
            if (before == null) {
                sun.putOnGround(cosine, atGround);
            } else {
                before.putGroundIrradiance(cosine, atGround);
            }
            radiance[0] += air.groundAlbedo().x() * transmittance[0] * atGround[0] / Math.PI;
            radiance[1] += air.groundAlbedo().y() * transmittance[1] * atGround[1] / Math.PI;
            radiance[2] += air.groundAlbedo().z() * transmittance[2] * atGround[2] / Math.PI;
        }
    }
}
