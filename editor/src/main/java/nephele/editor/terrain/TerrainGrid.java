package nephele.editor.terrain;

import nephele.engine.level.Terrain;
import nephele.engine.math.heightfield.SampleRange;

/**
 * The samples of a terrain's map in the world.
 *
 * @param leastX world x of column 0
 * @param leastZ world z of row 0
 * @param cellX distance of columns in metres
 */
record TerrainGrid(double leastX, double leastZ, double cellX, double cellZ, int columns, int rows) {
    static TerrainGrid of(Terrain authored, int columns, int rows) {
        return new TerrainGrid(
                authored.centre().x() - authored.sizeMetres().x() / 2,
                authored.centre().z() - authored.sizeMetres().z() / 2,
                authored.sizeMetres().x() / (columns - 1),
                authored.sizeMetres().z() / (rows - 1),
                columns,
                rows);
    }

    /** Returns a radius with which a dab reaches a sample wherever it is. */
    double effective(double radiusMetres) {
        return Math.max(radiusMetres, Math.max(cellX, cellZ));
    }

    /** Returns the samples within a distance along each axis; those beyond the border are left out. */
    SampleRange around(double x, double z, double metres) {
        return new SampleRange(
                (int) Math.max(0, Math.ceil((x - metres - leastX) / cellX)),
                (int) Math.max(0, Math.ceil((z - metres - leastZ) / cellZ)),
                (int) Math.min(columns - 1.0, Math.floor((x + metres - leastX) / cellX)),
                (int) Math.min(rows - 1.0, Math.floor((z + metres - leastZ) / cellZ)));
    }

    /** Returns a part with so many more samples on each side. */
    SampleRange grown(SampleRange part, int byColumns, int byRows) {
        return new SampleRange(
                Math.max(0, part.firstColumn() - byColumns),
                Math.max(0, part.firstRow() - byRows),
                Math.min(columns - 1, part.lastColumn() + byColumns),
                Math.min(rows - 1, part.lastRow() + byRows));
    }

    /** Returns the squared distance of a sample from a place, divided by the square of a radius. */
    double fractionSquared(int column, int row, double x, double z, double radius) {
        double dx = leastX + column * cellX - x;
        double dz = leastZ + row * cellZ - z;
        return (dx * dx + dz * dz) / (radius * radius);
    }
}
