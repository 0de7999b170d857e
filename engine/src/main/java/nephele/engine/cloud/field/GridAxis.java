package nephele.engine.cloud.field;

/** The voxel positions along one axis of a grid. */
final class GridAxis {
    /** The continuation of a grid beyond its first and last voxels. */
    enum Edge {
        /** Values beyond the outermost voxel centres equal theirs. */
        CLAMPED,
        /** The grid begins again. */
        REPEATED
    }

    private final double minMetres;
    private final double voxelsPerMetre;
    private final int voxels;
    private final Edge edge;

    GridAxis(double minMetres, double maxMetres, int voxels, Edge edge) {
        this.minMetres = minMetres;
        this.voxels = voxels;
        this.edge = edge;
        voxelsPerMetre = voxels / (maxMetres - minMetres);
    }

    /** Returns the position in voxels from the first voxel's centre, −½ to the number of voxels − ½. */
    double at(double metres) {
        double voxel = (metres - minMetres) * voxelsPerMetre;
        if (edge == Edge.REPEATED) {
            voxel -= voxels * Math.floor(voxel / voxels);
        }
        return voxel - 0.5;
    }

    /** Returns the index of the voxel whose centre is at or before a position with this floor. */
    int lower(int floor) {
        return floor >= 0 ? Math.min(floor, voxels - 1) : edge == Edge.CLAMPED ? 0 : voxels - 1;
    }

    /** Returns the index of the next voxel. */
    int upper(int floor) {
        return floor + 1 < voxels ? Math.max(0, floor + 1) : edge == Edge.CLAMPED ? voxels - 1 : 0;
    }
}
