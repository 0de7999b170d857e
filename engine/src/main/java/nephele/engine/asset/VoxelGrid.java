package nephele.engine.asset;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import nephele.engine.math.Aabb;
import nephele.engine.work.SwingThread;

/**
 * Densities at the centres of voxels, and their file: Mitsuba's grid volume format, version 3, with 32-bit floats and one
 * channel: "VOL", version, kind, counts of voxels, channels, box, values with x fastest; little-endian.
 *
 * @param nx voxels along x, at least 1; {@code ny} and {@code nz} likewise
 * @param box the region in metres that the grid's own file gives it
 * @param values densities, 0 to 1 in a file, x fastest, then y, then z
 */
public record VoxelGrid(int nx, int ny, int nz, Aabb box, float[] values) {
    private static final int HEADER_BYTES = 48;
    private static final int VERSION = 3;
    private static final int FLOAT_32 = 1;

    /** Most by which rounding may lift a density over 1. */
    private static final float TOLERANCE = 1e-6f;

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

    /**
     * Returns the densities of a file.
     *
     * @param assetId names the file in errors
     * @throws AssetException if it is no such file, is cut off, or has a density that is not in 0 to 1
     */
    public static VoxelGrid read(String assetId, byte[] bytes) throws AssetException {
        SwingThread.refuse("reading a grid");
        ByteBuffer file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (bytes.length < HEADER_BYTES || bytes[0] != 'V' || bytes[1] != 'O' || bytes[2] != 'L') {
            throw new AssetException(assetId, "is no Mitsuba .vol file", "write one of version 3");
        }
        if (bytes[3] != VERSION || file.getInt(4) != FLOAT_32 || file.getInt(20) != 1) {
            throw new AssetException(
                    assetId,
                    "has version " + bytes[3] + ", kind " + file.getInt(4) + " and " + file.getInt(20) + " channels",
                    "write version 3 with 32-bit floats (kind 1) and one channel");
        }
        long nx = file.getInt(8);
        long ny = file.getInt(12);
        long nz = file.getInt(16);
        long most = (bytes.length - HEADER_BYTES) / 4;
        if (nx < 1 || ny < 1 || nz < 1 || nx > most || ny > most / nx || nz > most / nx / ny) {
            throw new AssetException(
                    assetId,
                    "says " + nx + " x " + ny + " x " + nz + " voxels and has " + most + " values",
                    "write a value for each of at least one voxel");
        }
        float[] values = new float[(int) (nx * ny * nz)];
        file.position(HEADER_BYTES).asFloatBuffer().get(values);
        var grid = new VoxelGrid((int) nx, (int) ny, (int) nz, box(file), values);
        requireDensities(assetId, grid);
        return grid;
    }

    /**
     * Checks that a layer can repeat a grid at the width and depth of its box.
     *
     * @throws AssetException if it cannot
     */
    public static void requireArea(String assetId, Aabb box) throws AssetException {
        if (!isLength(box.maxX() - box.minX()) || !isLength(box.maxZ() - box.minZ())) {
            throw new AssetException(
                    assetId,
                    "has a bounding box of no width or depth, at which a layer repeats it",
                    "write the box in metres into its header, or make the cloud a volume");
        }
    }

    private static boolean isLength(double metres) {
        return metres > 0 && metres < Double.POSITIVE_INFINITY;
    }

    private static Aabb box(ByteBuffer file) {
        return new Aabb(
                file.getFloat(24),
                file.getFloat(28),
                file.getFloat(32),
                file.getFloat(36),
                file.getFloat(40),
                file.getFloat(44));
    }

    private static void requireDensities(String assetId, VoxelGrid grid) {
        float[] values = grid.values();
        for (int at = 0; at < values.length; at++) {
            if (!(values[at] >= 0 && values[at] <= 1 + TOLERANCE)) {
                int column = at % grid.nx();
                int layer = at / grid.nx() % grid.ny();
                int row = at / grid.nx() / grid.ny();
                throw new AssetException(
                        assetId,
                        "has density " + values[at] + " in voxel " + column + ", " + layer + ", " + row,
                        "scale all densities to 0 to 1");
            }
        }
    }
}
