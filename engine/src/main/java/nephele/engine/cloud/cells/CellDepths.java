package nephele.engine.cloud.cells;

import java.util.stream.IntStream;
import nephele.engine.cloud.light.AxisDepths;

/** Optical depths from the centres of coarse cells to the outside along the axes. */
final class CellDepths {
    private final DensityCells density;
    private final CellBox cells;
    /** Mean extinction. */
    private final float[] perMetre;

    /** Depth towards −x, −y, −z of each centre, three values a cell. */
    private final float[] minus;

    private final float[] plus;

    CellDepths(DensityCells density, CellBox cells) {
        this.density = density;
        this.cells = cells;
        perMetre = means();
        minus = new float[3 * cells.count()];
        plus = new float[3 * cells.count()];
        for (int axis = 0; axis < 3; axis++) {
            sum(axis);
        }
    }

    private float[] means() {
        float[] means = new float[cells.count()];
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            var place = new CellPlace(density.cells());
            for (int j = 0; j < cells.ny(); j++) {
                for (int i = 0; i < cells.nx(); i++) {
                    means[cells.index(i, j, k)] = mean(place, i, j, k);
                }
            }
        });
        return means;
    }

    private float mean(CellPlace place, int i, int j, int k) {
        double sum = 0;
        for (int n = 0; n < 8; n++) {
            place.at(
                    cells.centreX(i) + ((n & 1) - 0.5) / 2 * cells.sizeX(),
                    cells.centreY(j) + ((n >> 1 & 1) - 0.5) / 2 * cells.sizeY(),
                    cells.centreZ(k) + ((n >> 2) - 0.5) / 2 * cells.sizeZ());
            sum += place.of(density.densities(), 1, 0);
        }
        return (float) (sum / 8 * density.greatestPerMetre());
    }

    /** Sums along the lines of one axis. */
    private void sum(int axis) {
        int count = axis == 0 ? cells.nx() : axis == 1 ? cells.ny() : cells.nz();
        int stride = axis == 0 ? 1 : axis == 1 ? cells.nx() : cells.nx() * cells.ny();
        double half = (axis == 0 ? cells.sizeX() : axis == 1 ? cells.sizeY() : cells.sizeZ()) / 2;
        for (int at = 0; at < perMetre.length; at++) {
            if (at / stride % count == 0) {
                double sum = 0;
                for (int n = 0; n < count; n++) {
                    int cell = at + n * stride;
                    sum += half * perMetre[cell];
                    minus[3 * cell + axis] = (float) sum;
                    sum += half * perMetre[cell];
                }
                for (int n = 0; n < count; n++) {
                    int cell = at + n * stride;
                    plus[3 * cell + axis] = (float) (sum - minus[3 * cell + axis]);
                }
            }
        }
    }

    AxisDepths axes(int i, int j, int k) {
        int at = 3 * cells.index(i, j, k);
        return new AxisDepths(plus[at], minus[at], plus[at + 1], minus[at + 1], plus[at + 2], minus[at + 2]);
    }

    /** Returns the mean extinction of the cells. */
    float[] perMetre() {
        return perMetre;
    }
}
