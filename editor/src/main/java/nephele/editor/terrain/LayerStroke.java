package nephele.editor.terrain;

import java.util.Optional;
import java.util.OptionalDouble;
import nephele.editor.terrain.TerrainBrush.Effect;
import nephele.editor.text.Words;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Terrain;
import nephele.engine.math.heightfield.SampleRange;

/**
 * A stroke on a layer map. It keeps the fraction s of each texel that its dabs cover, 1 − ∏ (1 − falloff · strength), so that
 * the result does not depend on their order. Of a texel whose weight was a:
 *
 * <ul>
 *   <li>erasing leaves a (1 − s);
 *   <li>painting the same layer makes 1 − (1 − a) (1 − s);
 *   <li>painting another layer replaces it as soon as s is at least a (1 − s), with the sum of both as its weight: the
 *       boundary of two paints shows nothing between them. Below that the texel stays as it was.
 * </ul>
 */
public final class LayerStroke implements TerrainStroke {
    private final TerrainBrush brush;
    private final TerrainGrid grid;
    private final LayerMap before;
    private final double radius;
    private final float[] covered;
    private final Dabs dabs;
    private LayerMap map;
    /** What {@link #map} does not show yet; {@code null} for nothing. */
    private SampleRange unshown;

    private boolean isChange;
    private boolean isTooWeak;

    /**
     * Begins a stroke with its first dab.
     *
     * @param map its painted layers
     */
    public LayerStroke(Terrain authored, LayerMap map, TerrainBrush brush, double x, double z) {
        this.brush = brush;
        this.map = map;
        before = map;
        grid = TerrainGrid.of(authored, map.columns(), map.rows());
        radius = grid.effective(brush.radiusMetres());
        covered = new float[map.columns() * map.rows()];
        dabs = new Dabs(authored, radius / 4, radius, x, z);
        dab(x, z);
    }

    @Override
    public void to(double x, double z) {
        dabs.to(x, z, this::dab);
    }

    private void dab(double x, double z) {
        SampleRange part = grid.around(x, z, radius);
        if (part.isEmpty()) {
            return;
        }
        for (int row = part.firstRow(); row <= part.lastRow(); row++) {
            for (int column = part.firstColumn(); column <= part.lastColumn(); column++) {
                double fraction =
                        brush.strength() * TerrainBrush.falloff(grid.fractionSquared(column, row, x, z, radius));
                int at = row * grid.columns() + column;
                covered[at] = (float) (1 - (1 - covered[at]) * (1 - fraction));
            }
        }
        unshown = unshown == null ? part : unshown.union(part);
    }

    /** Returns the layers now; an object that was returned before does not change. */
    public LayerMap map() {
        if (unshown != null) {
            byte[] texels = map.texels().clone();
            for (int row = unshown.firstRow(); row <= unshown.lastRow(); row++) {
                for (int column = unshown.firstColumn(); column <= unshown.lastColumn(); column++) {
                    write(column, row, texels);
                }
            }
            map = new LayerMap(map.columns(), map.rows(), texels);
            unshown = null;
        }
        return map;
    }

    private void write(int column, int row, byte[] texels) {
        int texel = row * grid.columns() + column;
        double fraction = covered[texel];
        int layer = before.layer(column, row);
        double weight = before.weight(column, row) / (double) LayerMap.FULL_WEIGHT;
        if (brush.effect() == Effect.ERASE) {
            write(texel, layer, weight * (1 - fraction), texels);
        } else if (layer == brush.layer() || weight == 0) {
            write(texel, brush.layer(), 1 - (1 - weight) * (1 - fraction), texels);
        } else if (fraction >= weight * (1 - fraction)) {
            write(texel, brush.layer(), weight * (1 - fraction) + fraction, texels);
        } else {
            isTooWeak |= fraction > 0;
        }
    }

    /** Writes a texel; one without a weight has layer 0 unless it already was without one. */
    private void write(int texel, int layer, double weight, byte[] texels) {
        int at = LayerMap.TEXEL_BYTES * texel;
        byte rounded = (byte) Math.round(LayerMap.FULL_WEIGHT * weight);
        if (rounded == 0 && before.texels()[at + 1] == 0) {
            return;
        }
        texels[at] = (byte) (rounded == 0 ? 0 : layer);
        texels[at + 1] = rounded;
        isChange |= texels[at] != before.texels()[at] || rounded != before.texels()[at + 1];
    }

    @Override
    public boolean isTouched() {
        return isChange();
    }

    @Override
    public boolean isChange() {
        map();
        return isChange;
    }

    @Override
    public PaintedMaps.PaintedMap painted() {
        return PaintedMaps.PaintedMap.of(map());
    }

    @Override
    public Terrain on(Terrain authored, String file) {
        return authored.withLayerMap(file);
    }

    @Override
    public String name(Terrain authored) {
        return fileName(authored);
    }

    /** Returns the beginning of the name of a terrain's layer maps. */
    static String fileName(Terrain authored) {
        return authored.id() + "-layers";
    }

    @Override
    public OptionalDouble height(double x, double z) {
        return OptionalDouble.empty();
    }

    @Override
    public Optional<Words> notice() {
        return Optional.empty();
    }

    @Override
    public Optional<Words> objection() {
        return isTooWeak ? Optional.of(TerrainText.TOO_WEAK.words()) : Optional.empty();
    }
}
