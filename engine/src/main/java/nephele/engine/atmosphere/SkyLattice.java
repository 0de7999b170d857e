package nephele.engine.atmosphere;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import nephele.engine.math.Vec3;

/**
 * The integration of {@link ClearSky} at nodes of the sun's elevation, height, elevation and azimuth: a path tracer that
 * asks for the sky a million times has no time for the integration. Interpolation is cubic. Nodes are integrated when they are first needed, so a picture pays for the places and directions
 * that its paths leave from and to. Threads may share it.
 *
 * <p>Light scattered once is without its phase functions, which are evaluated for each direction. Of the sky's light the
 * square roots are interpolated, since it falls exponentially at dusk. Nothing is interpolated across the horizon.
 */
public final class SkyLattice {
    private static final double STEP_DEGREES = 0.5;
    private static final int CHANNELS = Air.CHANNELS;

    private final AirTables tables;
    private final double firstDegrees;
    private final Map<Integer, LatticeSheet> sheets = new ConcurrentHashMap<>();

    /** @param sunCosine between the zenith and the sun where most paths are: an elevation with nodes */
    public SkyLattice(AirTables tables, double sunCosine) {
        this.tables = tables;
        firstDegrees = degrees(sunCosine);
    }

    private static double degrees(double sine) {
        return Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, sine))));
    }

    /**
     * Returns the radiance without the sun's disc, per unit solar irradiance outside the air, 1/sr; as {@link
     * ClearSky#radiance}.
     *
     * @param zenithCosine between the zenith of the place and the direction
     * @param sunCosine between this zenith and the sun
     * @param betweenCosine between direction and sun
     */
    public Vec3 radiance(double heightMetres, double zenithCosine, double sunCosine, double betweenCosine) {
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        double between = Math.max(-1, Math.min(1, betweenCosine));
        LatticeRow row = LatticeRow.of(height, zenithCosine);
        double azimuth = azimuth(zenithCosine, sunCosine, between);
        double steps = (degrees(sunCosine) - firstDegrees) / STEP_DEGREES;
        int before = (int) Math.floor(steps);
        double[] weights = weights(before, steps - before);
        double[] parts = new double[LatticeSheet.VALUES];
        for (int k = 0; k < weights.length; k++) {
            if (weights[k] != 0) {
                sheet(before - 1 + k).add(height, row, azimuth, weights[k], parts);
            }
        }
        return light(row, between, parts);
    }

    /** Returns the weights of the nodes around the sun's elevation; next to zenith and nadir those of two. */
    private double[] weights(int before, double steps) {
        double[] weights = new double[4];
        double low = elevation(before);
        double high = elevation(before + 1);
        if (elevation(before - 1) > -90 && elevation(before + 2) < 90) {
            CubicWeights.put(steps, weights);
        } else {
            weights[2] = Math.min(1, steps * STEP_DEGREES / Math.max(1e-9, high - low));
            weights[1] = 1 - weights[2];
        }
        return weights;
    }

    /** Returns the elevation of a node of the sun, degrees; the uppermost one is the zenith. */
    private double elevation(int node) {
        return Math.max(-90, Math.min(90, firstDegrees + node * STEP_DEGREES));
    }

    private LatticeSheet sheet(int node) {
        return sheets.computeIfAbsent(node, key -> new LatticeSheet(tables, Math.sin(Math.toRadians(elevation(key)))));
    }

    private static double azimuth(double zenithCosine, double sunCosine, double between) {
        double level = Math.sqrt(Math.max(0, (1 - zenithCosine * zenithCosine) * (1 - sunCosine * sunCosine)));
        double cosine = level > 1e-14 ? (between - zenithCosine * sunCosine) / level : 1;
        return Math.acos(Math.max(-1, Math.min(1, cosine)));
    }

    private Vec3 light(LatticeRow row, double between, double[] parts) {
        double rayleigh = Air.rayleighPhase(between);
        double mie = tables.air().miePhase(between);
        double[] sum = new double[CHANNELS];
        for (int c = 0; c < CHANNELS; c++) {
            sum[c] = rayleigh * light(row, parts[c])
                    + mie * light(row, parts[CHANNELS + c])
                    + light(row, parts[2 * CHANNELS + c]);
        }
        return new Vec3(sum[0], sum[1], sum[2]);
    }

    private static double light(LatticeRow row, double part) {
        return row.isSky() ? part * part : Math.max(0, part);
    }
}
