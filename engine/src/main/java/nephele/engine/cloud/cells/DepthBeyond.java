package nephele.engine.cloud.cells;

/** The optical depth of what lies outside a box of cells. */
@FunctionalInterface
public interface DepthBeyond {
    /** There is nothing outside. */
    DepthBeyond NOTHING = (x, y, z, dx, dy, dz) -> 0;

    /** Returns the optical depth from a point of the box's surface outwards, along a unit direction. */
    double depth(double x, double y, double z, double dx, double dy, double dz);
}
