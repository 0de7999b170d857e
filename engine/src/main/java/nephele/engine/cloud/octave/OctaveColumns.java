package nephele.engine.cloud.octave;

import nephele.engine.cloud.cells.DensityCells;

/**
 * The columns of octaves of noise at one time, even from base to top. All of them count as cloud, so that there is light
 * wherever the finer noise of a drawn sheet is.
 *
 * @param perMetre extinction of the greatest optical depth
 */
public record OctaveColumns(OctaveSheet sheet, double seconds, double perMetre) implements DensityCells.Columns {
    @Override
    public double depth(double x, double z) {
        return sheet.at(x, z, seconds);
    }

    @Override
    public double greatestDepth(double x, double z, double halfX, double halfZ) {
        return 1;
    }

    @Override
    public double leastDepth(double fromY, double toY) {
        return 0;
    }

    @Override
    public double perMetre(double depth, double x, double y, double z) {
        return depth * perMetre;
    }
}
