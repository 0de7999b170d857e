package nephele.engine.atmosphere;

import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;

/**
 * Computes the light field in the air order by order of scattering: the light of each order is scattered once more, by
 * the air and by the ground, until an order adds less than a thousandth anywhere.
 */
final class ScatteringOrders {
    /** Degree of the moments of light scattered once, whose aureole is narrow, and of light scattered more often. */
    static final int FIRST_DEGREE = 10;

    private static final int DEGREE = 4;
    private static final double LEAST_SHARE = 1e-3;
    private static final double DARK = 1e-12;
    private static final int MOST_ORDERS = 40;

    private final Air air;
    private final SunTransmittance sun;
    private final double[] mieMoments;
    private final double[][] sums;
    private final double[] groundSums = new double[LightField.SUNS * Air.CHANNELS];
    private double share;

    private ScatteringOrders(Air air, SunTransmittance sun) {
        this.air = air;
        this.sun = sun;
        mieMoments = RepeatedScattering.mieMoments(air, FIRST_DEGREE);
        sums = new double[LightField.HEIGHTS * LightField.SUNS * Air.CHANNELS][DirectionMoments.count(FIRST_DEGREE)];
    }

    /**
     * Returns the field of all orders: light scattered at least once, or reflected by the ground.
     *
     * @param progress the completed share, estimated from the light that the last order added
     */
    static LightField sum(Air air, SunTransmittance sun, DoubleConsumer progress) {
        progress.accept(0);
        ScatteringOrders orders = new ScatteringOrders(air, sun);
        LightField last = orders.next(null, FIRST_DEGREE);
        for (int order = 2; order <= MOST_ORDERS && orders.share > LEAST_SHARE; order++) {
            progress.accept(Math.max(0, Math.log(orders.share) / Math.log(LEAST_SHARE)));
            last = orders.next(last.refined(), DEGREE);
        }
        progress.accept(1);
        return orders.total();
    }

    private LightField next(LightField before, int degree) {
        LightField now = new LightField(degree);
        double[] shares = new double[LightField.HEIGHTS];
        IntStream.range(0, LightField.HEIGHTS).parallel().forEach(height -> {
            SkyDirections directions =
                    new SkyDirections(LightField.heightMetres(height), degree, before == null ? 16 : 8);
            Order order = before == null ? new Order(air, sun) : new Order(air, sun, before, mieMoments);
            for (int i = 0; i < LightField.SUNS; i++) {
                shares[height] = Math.max(shares[height], put(order, directions, height, i, now));
            }
        });
        share = IntStream.range(0, shares.length)
                .mapToDouble(j -> shares[j])
                .max()
                .orElse(0);
        return now;
    }

    /** Sets a node of the field and adds it to the sums; returns the greatest share that it adds. */
    private double put(Order order, SkyDirections directions, int height, int i, LightField field) {
        double sunCosine = LightField.sunCosine(i);
        double[][] moments = new double[Air.CHANNELS][DirectionMoments.count(field.degree())];
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
        double most = 0;
        for (int c = 0; c < Air.CHANNELS; c++) {
            field.set(height, i, c, moments[c]);
            double[] sum = sums[(height * LightField.SUNS + i) * Air.CHANNELS + c];
            for (int k = 0; k < moments[c].length; k++) {
                sum[k] += moments[c][k];
            }
            most = Math.max(most, sum[0] > DARK ? moments[c][0] / sum[0] : 0);
            if (height == 0) {
                field.setGroundIrradiance(i, c, irradiance[c]);
                groundSums[i * Air.CHANNELS + c] += irradiance[c];
            }
        }
        return most;
    }

    private LightField total() {
        LightField total = new LightField(FIRST_DEGREE);
        for (int height = 0; height < LightField.HEIGHTS; height++) {
            for (int i = 0; i < LightField.SUNS; i++) {
                for (int c = 0; c < Air.CHANNELS; c++) {
                    total.set(height, i, c, sums[(height * LightField.SUNS + i) * Air.CHANNELS + c]);
                    total.setGroundIrradiance(i, c, groundSums[i * Air.CHANNELS + c]);
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
        Order(Air air, SunTransmittance sun, LightField before, double[] mieMoments) {
            this.air = air;
            this.sun = new Sunlight(sun, 0);
            this.before = before;
            source = new RepeatedScattering(air, before, mieMoments);
            integral = new AirIntegral(air, AirIntegral.COARSE);
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
