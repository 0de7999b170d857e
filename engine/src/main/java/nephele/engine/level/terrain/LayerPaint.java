package nephele.engine.level.terrain;

import java.util.Optional;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Terrain;

/**
 * The painted layers of a terrain. The texels of its layer map lie at equal distances, the outer ones on the terrain's
 * border, as the samples of heights do. Between four texels each one adds its weight, times its bilinear share, to its
 * own layer; the mixture by height and slope keeps the rest, so that the sum of all weights stays 1. Indices are never
 * interpolated. The shader of the terrain has the same lines.
 */
public final class LayerPaint {
    private final LayerMap map;
    private final double leastX;
    private final double leastZ;
    private final double columnsPerMetre;
    private final double rowsPerMetre;

    /** Makes the paint of a map on a terrain. */
    public LayerPaint(Terrain authored, LayerMap map) {
        this.map = map;
        leastX = authored.centre().x() - authored.sizeMetres().x() / 2;
        leastZ = authored.centre().z() - authored.sizeMetres().z() / 2;
        columnsPerMetre = (map.columns() - 1) / authored.sizeMetres().x();
        rowsPerMetre = (map.rows() - 1) / authored.sizeMetres().z();
    }

    /**
     * Replaces weights of layers by what is painted at a place.
     *
     * @param x in world metres; a place beside the terrain has the paint of the border
     * @param weights of all layers by height and slope, whose sum is 1
     */
    public void over(double x, double z, double[] weights) {
        double column = clamp((x - leastX) * columnsPerMetre, map.columns() - 1);
        double row = clamp((z - leastZ) * rowsPerMetre, map.rows() - 1);
        int left = Math.min((int) column, map.columns() - 2);
        int top = Math.min((int) row, map.rows() - 2);
        double u = column - left;
        double v = row - top;
        double[] fractions = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
        double kept = 0;
        for (int i = 0; i < fractions.length; i++) {
            kept += fractions[i] * (1 - weight(left + i % 2, top + i / 2));
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] *= kept;
        }
        for (int i = 0; i < fractions.length; i++) {
            double weight = weight(left + i % 2, top + i / 2);
            if (weight > 0) {
                weights[map.layer(left + i % 2, top + i / 2)] += fractions[i] * weight;
            }
        }
    }

    private double weight(int column, int row) {
        return map.weight(column, row) / (double) LayerMap.FULL_WEIGHT;
    }

    private static double clamp(double value, double most) {
        return Math.max(0, Math.min(value, most));
    }

    /**
     * Reads the layer map of a terrain; empty if it has none, or if it has too few layers for paint to be seen.
     *
     * @throws AssetException if the file is missing or unusable, or names a layer that the terrain does not have
     */
    public static Optional<LayerMap> read(Terrain authored, AssetSource assets) {
        if (authored.layerMap() == null) {
            return Optional.empty();
        }
        LayerMap map = assets.decoded(authored.layerMap(), LayerMap.class, LayerMap::read);
        requireLayers(authored, map);
        return authored.layers().size() < 2 ? Optional.empty() : Optional.of(map);
    }

    /**
     * Checks that a terrain has all layers that a map names with a weight.
     *
     * @throws AssetException that names the first texel without one
     */
    public static void requireLayers(Terrain authored, LayerMap map) {
        int layers = authored.layers().size();
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                if (map.layer(column, row) >= layers && map.weight(column, row) > 0) {
                    throw new AssetException(
                            authored.layerMap(),
                            "paints layer " + map.layer(column, row) + " at pixel (" + column + ", " + row + "), and '"
                                    + authored.id() + "' has "
                                    + (layers == 0 ? "no layers" : "layers 0 to " + (layers - 1)),
                            "give the terrain that layer, or name another layerMap or none");
                }
            }
        }
    }
}
