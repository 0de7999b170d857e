package nephele.engine.cloud.field;

import nephele.engine.math.Aabb;

/**
 * A lattice of equal boxes. Cell (0, 0, 0) begins at the origin; indices may be negative.
 *
 * @param originX metres, as all members
 */
record CellLattice(double originX, double originY, double originZ, double sizeX, double sizeY, double sizeZ) {
    /** Returns the lattice that divides a finite box into the given numbers of cells. */
    static CellLattice dividing(Aabb box, int columns, int layers, int rows) {
        return new CellLattice(
                box.minX(),
                box.minY(),
                box.minZ(),
                (box.maxX() - box.minX()) / columns,
                (box.maxY() - box.minY()) / layers,
                (box.maxZ() - box.minZ()) / rows);
    }
}
