package nephele.engine.atmosphere;

import java.util.concurrent.atomic.AtomicReferenceArray;
import nephele.engine.math.Vec3;

/**
 * The integration of {@link ClearSky} for one sun, at nodes of height, elevation and azimuth with cubic interpolation
 * between them: a path tracer that asks for the sky a million times has no time for the integration. A row of nodes is
 * integrated when it is first needed, so a picture pays for the heights and directions that its paths leave to. Threads
 * may share it; two may integrate the same row, with the same result.
 *
 * <p>Light scattered once is without its phase functions, which are evaluated for each direction. Of the sky's light the
 * square roots are interpolated, since it falls exponentially at dusk. Nothing is interpolated across the horizon.
 */
public final class SkyLattice {
    private static final int HEIGHTS = 65;
    private static final int ROWS = LatticeRow.SKY + LatticeRow.GROUND;
    private static final int AZIMUTHS = 21;
    private static final int CHANNELS = Air.CHANNELS;
    private static final int VALUES = ClearSky.PARTS * CHANNELS;
    private static final int NEIGHBOURS = 4;

    private final AirTables tables;
    private final Vec3 towardsSun;
    private final double sunLevel;
    private final AtomicReferenceArray<double[]> rows = new AtomicReferenceArray<>(HEIGHTS * ROWS);

    /** @param towardsSun unit, +y is the zenith */
    public SkyLattice(AirTables tables, Vec3 towardsSun) {
        this.tables = tables;
        this.towardsSun = towardsSun;
        sunLevel = Math.hypot(towardsSun.x(), towardsSun.z());
    }

    /**
     * Returns the radiance without the sun's disc, per unit solar irradiance outside the air, 1/sr; as {@link
     * ClearSky#radiance}.
     *
     * @param direction unit
     */
    public Vec3 radiance(double heightMetres, Vec3 direction) {
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        LatticeRow row = LatticeRow.of(height, direction.y());
        double[] parts = interpolated(height, row, azimuth(direction));
        double between = Math.max(-1, Math.min(1, direction.dot(towardsSun)));
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
        return row.isSky() ? part * part : part;
    }

    /** Returns the angle between direction and sun on the horizon, 0 to π. */
    private double azimuth(Vec3 d) {
        double level = sunLevel * Math.hypot(d.x(), d.z());
        double cosine = level > 1e-14 ? (d.x() * towardsSun.x() + d.z() * towardsSun.z()) / level : 1;
        return Math.acos(Math.max(-1, Math.min(1, cosine)));
    }

    private double[] interpolated(double height, LatticeRow row, double azimuth) {
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
        double[] sum = new double[VALUES];
        for (int j = 0; j < NEIGHBOURS; j++) {
            for (int i = 0; i < NEIGHBOURS; i++) {
                double weight = ofHeight[j] * ofRow[i];
                if (weight != 0) {
                    add(nodes(layer - 1 + j, first + i), column, ofAzimuth, weight, sum);
                }
            }
        }
        return sum;
    }

    /** The light is the same on both sides of the plane through zenith and sun, so the azimuths continue mirrored. */
    private static void add(double[] nodes, int column, double[] ofAzimuth, double weight, double[] sum) {
        for (int k = 0; k < NEIGHBOURS; k++) {
            int node = Math.abs(column - 1 + k);
            node = Math.min(node, 2 * (AZIMUTHS - 1) - node);
            double share = weight * ofAzimuth[k];
            for (int value = 0; value < VALUES; value++) {
                sum[value] += share * nodes[node * VALUES + value];
            }
        }
    }

    private double[] nodes(int layer, int row) {
        int at = layer * ROWS + row;
        double[] known = rows.get(at);
        if (known == null) {
            known = integrated(layer, row);
            rows.set(at, known);
        }
        return known;
    }

    private double[] integrated(int layer, int row) {
        double share = layer / (HEIGHTS - 1.0);
        double height = Air.TOP_METRES * share * share;
        boolean isSky = row < LatticeRow.SKY;
        double sine = isSky ? LatticeRow.skySine(height, row) : LatticeRow.groundSine(height, row - LatticeRow.SKY);
        double level = Math.sqrt(Math.max(0, 1 - sine * sine)) * sunLevel;
        ClearSky sky = new ClearSky(tables);
        AirRay ray = new AirRay();
        double[] parts = new double[VALUES];
        double[] nodes = new double[AZIMUTHS * VALUES];
        for (int k = 0; k < AZIMUTHS; k++) {
            double between = sine * towardsSun.y() + level * Math.cos(Math.PI * k / (AZIMUTHS - 1));
            ray.set(height, sine, towardsSun.y(), Math.max(-1, Math.min(1, between)));
            sky.put(ray, parts);
            for (int value = 0; value < VALUES; value++) {
                nodes[k * VALUES + value] = isSky ? Math.sqrt(Math.max(0, parts[value])) : parts[value];
            }
        }
        return nodes;
    }
}
