package nephele.engine.cloud.cells;

import java.util.List;
import nephele.engine.cloud.light.CloudLight;

/**
 * A cloud as it is marched: boxes of cells of extinction and light. A finite cloud has one box. A layer has several
 * around the same point of the same heights, each four times as wide as the one before; a place belongs to the narrowest
 * that contains it.
 *
 * @param density from the narrowest box on, of one scale
 * @param light of the same boxes
 * @param planetRadiusMetres of the planet around which a layer bends; infinite for a flat one
 */
public record CellStack(
        List<DensityCells> density, List<LightCells> light, CloudLight physics, double planetRadiusMetres) {
    /** Widths of successive boxes. */
    public static final int WIDENING = 4;

    public CellStack {
        density = List.copyOf(density);
        light = List.copyOf(light);
    }

    /** Returns the box of the narrowest cells. */
    public CellBox narrowest() {
        return density.get(0).cells();
    }

    public int levels() {
        return density.size();
    }

    /** Returns true if there is nothing to draw. */
    public boolean isEmpty() {
        return density.stream().allMatch(DensityCells::isEmpty);
    }

    /** Returns the extinction that density 1 stands for. */
    public double greatestPerMetre() {
        return density.get(0).greatestPerMetre();
    }

    /** Returns the same cells in other light. */
    public CellStack lit(List<LightCells> now) {
        return new CellStack(density, now, physics, planetRadiusMetres);
    }
}
