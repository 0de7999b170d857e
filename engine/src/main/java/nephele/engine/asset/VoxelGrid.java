package nephele.engine.asset;

import nephele.engine.math.Aabb;

/**
 * Densities at the centres of voxels.
 *
 * @param nx voxels along x, at least 1; {@code ny} and {@code nz} likewise
 * @param box the region in metres that the grid's own file gives it
 * @param values densities, 0 to 1 in a file, x fastest, then y, then z
 */
public record VoxelGrid(int nx, int ny, int nz, Aabb box, float[] values) {
    public VoxelGrid {
        if (nx < 1 || ny < 1 || nz < 1 || (long) nx * ny * nz != values.length) {
            throw new IllegalArgumentException(
                    values.length + " values do not fill " + nx + " x " + ny + " x " + nz + " voxels");
        }
    }

    /** Returns the same densities with another region. */
    public VoxelGrid movedTo(Aabb region) {
        return new VoxelGrid(nx, ny, nz, region, values);
    }

    /** Returns the density of a voxel. */
    public float value(int i, int j, int k) {
        return values[(k * ny + j) * nx + i];
    }
}
