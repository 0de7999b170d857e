package nephele.engine.model;

/** Limits of the sizes of meshes and their files, so that no file and no parameter exhausts the memory. */
public final class MeshLimits {
    public static final int MAX_TRIANGLES = 1 << 22;

    public static final int MAX_VERTICES = 1 << 22;

    /** Maximum number of corners of one polygon. */
    public static final int MAX_CORNERS = 4096;

    /** Maximum bytes of a text file, read or written; larger ones take seconds to read. */
    public static final int MAX_TEXT_BYTES = 64 << 20;

    /** Maximum bytes of a glTF file, and of all its buffers; a mesh in memory is larger. */
    public static final int MAX_GLTF_BYTES = 32 << 20;

    /** Maximum number of vertices, and of triangles, of all nodes of a glTF file. */
    public static final int MAX_GLTF_VERTICES = 2_000_000;

    /** Largest coordinate; up to it the spacing of floats is about 6 cm or less if units are metres. */
    public static final double MAX_COORDINATE_UNITS = 1e6;

    private MeshLimits() {}
}
