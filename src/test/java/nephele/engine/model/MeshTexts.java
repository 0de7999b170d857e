package nephele.engine.model;

import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Texts of mesh files at the limits of the formats. */
public final class MeshTexts {
    /** A {@code .3d} file with one triangle that is a line. */
    public static final String LINE = "0 0 0\n1 0 0\n2 0 0\n\n0 1 2\n";

    /** A glTF file with a triangle at a node with an all-zero matrix. */
    public static final String ZERO_GLTF =
            """
            { "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }],
              "nodes": [{ "mesh": 0, "matrix": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0] }],
              "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
              "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" }],
              "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
              "buffers": [{ "byteLength": 36, "uri":
                "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA" }] }
            """;

    private MeshTexts() {}

    /** Returns a regular polygon around the origin as an OBJ file. */
    public static String polygon(int corners) {
        String points = IntStream.range(0, corners)
                .mapToDouble(i -> 2 * Math.PI * i / corners)
                .mapToObj(angle -> "v " + (float) StrictMath.cos(angle) + " " + (float) StrictMath.sin(angle) + " 0\n")
                .collect(Collectors.joining());
        return points
                + IntStream.rangeClosed(1, corners)
                        .mapToObj(Integer::toString)
                        .collect(Collectors.joining(" ", "f ", "\n"));
    }
}
