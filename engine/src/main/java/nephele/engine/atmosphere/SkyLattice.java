package nephele.engine.atmosphere;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReferenceArray;
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
    private static final int VALUES = ClearSky.PARTS * CHANNELS;
    private static final int HEIGHTS = 65;
    private static final int ROWS = LatticeRow.SKY + LatticeRow.GROUND;
    private static final int AZIMUTHS = 21;
    private static final int NEIGHBOURS = 4;

    private final AirTables tables;
    private final double firstDegrees;

    /**
     * The rows of nodes for each elevation of the sun, height by height. A row is integrated when it is first needed; two
     * threads may integrate the same one, with the same result.
     */
    private final Map<Integer, AtomicReferenceArray<double[]>> sheets = new ConcurrentHashMap<>();

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
        double[] parts = new double[VALUES];
        for (int k = 0; k < weights.length; k++) {
            if (weights[k] != 0) {
                add(before - 1 + k, height, row, azimuth, weights[k], parts);
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

    /**
     * Adds the interpolated values: the parts of the ground's light, the roots of those of the sky's.
     *
     * @param sun node of its elevation
     * @param azimuth between direction and sun on the horizon, 0 to π
     */
    private void add(int sun, double height, LatticeRow row, double azimuth, double factor, double[] sum) {
        AtomicReferenceArray<double[]> sheet =
                sheets.computeIfAbsent(sun, key -> new AtomicReferenceArray<>(HEIGHTS * ROWS));
        double[] ofHeight = new double[NEIGHBOURS];
        double y = Math.sqrt(height / Air.TOP_METRES) * (HEIGHTS - 1);
        int layer = CubicWeights.cell(y, HEIGHTS);
        CubicWeights.put(y - layer, layer, HEIGHTS, ofHeight);
        double[] ofRow = new double[NEIGHBOURS];
        int elevation = CubicWeights.cell(row.place(), row.rows());
        CubicWeights.put(row.place() - elevation, elevation, row.rows(), ofRow);
        double[] ofAzimuth = new double[NEIGHBOURS];
        double x = azimuth / Math.PI * (AZIMUTHS - 1);
        int column = CubicWeights.cell(x, AZIMUTHS);
        CubicWeights.put(x - column, ofAzimuth);
        int first = (row.isSky() ? 0 : LatticeRow.SKY) + elevation - 1;
        for (int j = 0; j < NEIGHBOURS; j++) {
            for (int i = 0; i < NEIGHBOURS; i++) {
                double weight = factor * ofHeight[j] * ofRow[i];
                if (weight != 0) {
                    addRow(nodes(sheet, sun, layer - 1 + j, first + i), column, ofAzimuth, weight, sum);
                }
            }
        }
    }

    /** The light is the same on both sides of the plane through zenith and sun, so the azimuths continue mirrored. */
    private static void addRow(double[] nodes, int column, double[] ofAzimuth, double weight, double[] sum) {
        for (int k = 0; k < NEIGHBOURS; k++) {
            int node = Math.abs(column - 1 + k);
            node = Math.min(node, 2 * (AZIMUTHS - 1) - node);
            double ofNode = weight * ofAzimuth[k];
            for (int value = 0; value < VALUES; value++) {
                sum[value] += ofNode * nodes[node * VALUES + value];
            }
        }
    }

    private double[] nodes(AtomicReferenceArray<double[]> sheet, int sun, int layer, int row) {
        int at = layer * ROWS + row;
        double[] known = sheet.get(at);
        if (known == null) {
            known = integrated(Math.sin(Math.toRadians(elevation(sun))), layer, row);
            sheet.set(at, known);
        }
        return known;
    }

    private double[] integrated(double sunCosine, int layer, int row) {
        double fraction = layer / (HEIGHTS - 1.0);
        double height = Air.TOP_METRES * fraction * fraction;
        boolean isSky = row < LatticeRow.SKY;
        double sine = isSky ? LatticeRow.skySine(height, row) : LatticeRow.groundSine(height, row - LatticeRow.SKY);
        double level = Math.sqrt(Math.max(0, (1 - sine * sine) * (1 - sunCosine * sunCosine)));
        ClearSky sky = new ClearSky(tables);
        AirRay ray = new AirRay(tables.air().shadowEdgeRadians(), 0);
        double[] parts = new double[VALUES];
        double[] nodes = new double[AZIMUTHS * VALUES];
        for (int k = 0; k < AZIMUTHS; k++) {
            double between = sine * sunCosine + level * Math.cos(Math.PI * k / (AZIMUTHS - 1));
            ray.set(height, sine, sunCosine, Math.max(-1, Math.min(1, between)));
            sky.put(ray, parts);
            for (int value = 0; value < VALUES; value++) {
                nodes[k * VALUES + value] = isSky ? Math.sqrt(Math.max(0, parts[value])) : parts[value];
            }
        }
        return nodes;
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
