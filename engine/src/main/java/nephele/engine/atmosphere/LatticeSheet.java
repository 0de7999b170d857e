package nephele.engine.atmosphere;

import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * The nodes of a {@link SkyLattice} for one elevation of the sun. A row of them is integrated when it is first needed.
 * Threads may share it; two may integrate the same row, with the same result.
 */
final class LatticeSheet {
    static final int VALUES = ClearSky.PARTS * Air.CHANNELS;

    private static final int HEIGHTS = 65;
    private static final int ROWS = LatticeRow.SKY + LatticeRow.GROUND;
    private static final int AZIMUTHS = 21;
    private static final int NEIGHBOURS = 4;

    private final AirTables tables;
    private final double sunCosine;
    private final AtomicReferenceArray<double[]> rows = new AtomicReferenceArray<>(HEIGHTS * ROWS);

    /** @param sunCosine between the zenith and the sun */
    LatticeSheet(AirTables tables, double sunCosine) {
        this.tables = tables;
        this.sunCosine = sunCosine;
    }

    /**
     * Adds the interpolated values: the parts of the ground's light, the roots of those of the sky's.
     *
     * @param azimuth between direction and sun on the horizon, 0 to π
     */
    void add(double height, LatticeRow row, double azimuth, double share, double[] sum) {
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
                double weight = share * ofHeight[j] * ofRow[i];
                if (weight != 0) {
                    addRow(nodes(layer - 1 + j, first + i), column, ofAzimuth, weight, sum);
                }
            }
        }
    }

    /** The light is the same on both sides of the plane through zenith and sun, so the azimuths continue mirrored. */
    private static void addRow(double[] nodes, int column, double[] ofAzimuth, double weight, double[] sum) {
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
        double level = Math.sqrt(Math.max(0, (1 - sine * sine) * (1 - sunCosine * sunCosine)));
        ClearSky sky = new ClearSky(tables);
        AirRay ray = new AirRay(tables.air().sunRadiusRadians(), 0);
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
}
