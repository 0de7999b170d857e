package nephele.engine.model;

/** How large a mesh and the text of one may be, so that no file and no number exhausts the memory. */
final class MeshLimits {
    static final int MAX_TRIANGLES = 1 << 22;

    static final int MAX_VERTICES = 1 << 22;

    /** Limit for one polygon. */
    static final int MAX_CORNERS = 4096;

    /** Bytes of a text file, read or written; larger ones would take seconds to read. */
    static final int MAX_TEXT_BYTES = 64 << 20;

    /** Bytes of a glTF file, and of all its buffers: it is held a few times over while it is read. */
    static final int MAX_GLTF_BYTES = 32 << 20;

    /** Vertices, or triangles, of all nodes of a glTF file. */
    static final int MAX_GLTF_VERTICES = 2_000_000;

    /** Largest coordinate: beyond, a float holds no more than 6 cm. */
    static final double MAX_COORDINATE = 1e6;

    private MeshLimits() {}
}
