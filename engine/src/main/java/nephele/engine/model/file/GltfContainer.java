package nephele.engine.model.file;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelFileException;

/**
 * The contents of a .gltf or .glb file: the JSON text and, in a .glb, the bytes of its first buffer.
 *
 * @param binary {@code null} if there are none
 */
record GltfContainer(byte[] json, byte[] binary) {
    private static final int MAGIC = 0x46546C67;
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;

    static GltfContainer of(String file, byte[] bytes) {
        if (bytes.length > MeshLimits.MAX_GLTF_BYTES) {
            throw new ModelFileException(
                    file, 0, "is larger than " + (MeshLimits.MAX_GLTF_BYTES >> 20) + " MiB", "make the mesh coarser");
        }
        ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        boolean binary = bytes.length >= 4 && data.getInt(0) == MAGIC;
        return binary ? ofChunks(file, data) : new GltfContainer(bytes, null);
    }

    private static GltfContainer ofChunks(String file, ByteBuffer data) {
        if (data.limit() < HEADER_BYTES + CHUNK_HEADER_BYTES) {
            throw wrong(file, data.limit(), "the file ends within its header");
        }
        if (data.getInt(4) != 2) {
            throw wrong(file, 4, "is version " + Integer.toUnsignedString(data.getInt(4)) + " of the container, not 2");
        }
        if (data.getInt(8) != data.limit()) {
            throw wrong(
                    file,
                    8,
                    "says that it has " + Integer.toUnsignedString(data.getInt(8)) + " bytes, but has " + data.limit());
        }
        byte[] json = chunk(file, data, HEADER_BYTES, JSON_CHUNK);
        int next = HEADER_BYTES + CHUNK_HEADER_BYTES + json.length;
        byte[] binary = next == data.limit() ? null : chunk(file, data, next, BINARY_CHUNK);
        return new GltfContainer(json, binary);
    }

    private static byte[] chunk(String file, ByteBuffer data, int at, int kind) {
        if (at + CHUNK_HEADER_BYTES > data.limit()) {
            throw wrong(file, at, "the file ends within a chunk's header");
        }
        int length = data.getInt(at);
        int start = at + CHUNK_HEADER_BYTES;
        if (data.getInt(at + 4) != kind) {
            throw wrong(file, at + 4, "the chunk is not the one expected there");
        }
        if (length < 0 || length > data.limit() - start) {
            throw wrong(
                    file, at, "a chunk of " + Integer.toUnsignedString(length) + " bytes goes beyond the file's end");
        }
        return Arrays.copyOfRange(data.array(), start, start + length);
    }

    private static ModelFileException wrong(String file, int at, String reason) {
        return new ModelFileException(file, 0, "byte " + at + ": " + reason, "export it again");
    }
}
