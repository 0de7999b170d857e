package nephele.editor.file;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import nephele.engine.math.Vec3;

/** The first bytes of a Mitsuba .vol file, version 3, little-endian: magic, kind, counts of voxels, channels, box. */
final class VolumeHeader {
    private static final int BYTES = 48;
    private static final int FLOAT_32 = 1;
    private static final int VERSION = 3;
    private static final double LARGEST_METRES = 1e5;

    private VolumeHeader() {}

    /** Returns why the content is no grid of densities; empty if it is one. */
    static Optional<String> objection(byte[] content) {
        if (content.length < BYTES || content[0] != 'V' || content[1] != 'O' || content[2] != 'L') {
            return Optional.of("it is no Mitsuba .vol file");
        }
        ByteBuffer header = header(content);
        long voxels = (long) header.getInt(8) * header.getInt(12) * header.getInt(16);
        boolean isDensity = content[3] == VERSION && header.getInt(4) == FLOAT_32 && header.getInt(20) == 1;
        if (!isDensity) {
            return Optional.of("it must be of version 3 with 32-bit floats and one channel");
        }
        return voxels > 0 && content.length - BYTES >= 4 * voxels
                ? Optional.empty()
                : Optional.of("it has fewer values than its header says");
    }

    /** Returns the size of the file's box, or one of 40 m if that is no size of a cloud. */
    static Vec3 sizeMetres(byte[] content) {
        ByteBuffer header = header(content);
        double[] size = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            size[axis] = header.getFloat(36 + 4 * axis) - (double) header.getFloat(24 + 4 * axis);
            if (!(size[axis] >= 0.1 && size[axis] <= LARGEST_METRES)) {
                return new Vec3(40, 40, 40);
            }
        }
        return new Vec3(size[0], size[1], size[2]);
    }

    private static ByteBuffer header(byte[] content) {
        return ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
    }
}
