package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Levels that are odd and accepted. Each has the path and the words of the one warning that {@code check} gives of it;
 * both are empty where it gives none.
 */
public final class OddLevels {
    static final List<BadLevel> ALL = List.of(
            drawsNothing("a line of points", "line.3d", ""),
            drawsNothing("an all-zero glTF matrix", "zero.gltf", ""),
            drawsNothing(
                    "a box made a sheet by its scale", "box_1_1.3d", "{\"kind\": \"scale\", \"by\": [1e6, 1e-6, 1]}"),
            accepted("a polygon of 4096 corners", model("polygon.obj", "")),
            accepted("a backslash at the end of an OBJ", model("backslash.obj", "")),
            accepted(
                    "a needle of 62 sides",
                    "\"player\": {\"feet\": [0, 0, 5]}, \"solids\": [{\"id\": \"p\", \"kind\": \"prism\", \"centre\":"
                            + " [0, 0, 0], \"radiusMetres\": 0.001, \"heightMetres\": 10000, \"sides\": 62}]"),
            accepted("3 000 identical boxes", boxes(3_000, i -> "[2, 0.5, 0], \"size\": [1, 1, 1]")),
            accepted(
                    "10 000 boxes 1 mm apart",
                    boxes(
                            10_000,
                            i -> "[" + (811 + i % 100) / 1e3 + ", " + (500 + i / 100) / 1e3
                                    + ", 0], \"size\": [1, 1, 1]")),
            accepted(
                    "10 000 boxes with gaps of 1 mm around the player's knees",
                    boxes(
                            10_000,
                            i -> "[" + (11 * (i % 100) - 544.5) / 1e3 + ", 0.5, " + (11 * (i / 100) - 544.5) / 1e3
                                    + "], \"size\": [0.01, 0.01, 0.01]")));

    private OddLevels() {}

    /** Writes the meshes that they name into a folder. */
    static void prepare(Path folder) throws IOException {
        Files.writeString(folder.resolve("line.3d"), "0 0 0\n1 0 0\n2 0 0\n\n0 1 2\n");
        Files.writeString(folder.resolve("backslash.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\");
        Files.writeString(folder.resolve("polygon.obj"), polygon(4096));
        Files.writeString(
                folder.resolve("zero.gltf"),
                """
                { "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }],
                  "nodes": [{ "mesh": 0, "matrix": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0] }],
                  "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
                  "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" }],
                  "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
                  "buffers": [{ "byteLength": 36, "uri":
                    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA" }] }
                """);
    }

    /** A regular polygon around the origin, in an OBJ file. */
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

    private static BadLevel accepted(String name, String sections) {
        return named(name, level("", "", sections));
    }

    private static BadLevel drawsNothing(String name, String file, String step) {
        return named(
                name, level("models[0]", "'m' draws nothing: none of the triangles of " + file, model(file, step)));
    }

    private static BadLevel named(String name, BadLevel odd) {
        return new BadLevel(name, odd.path(), odd.words(), odd.content());
    }

    private static String model(String file, String step) {
        return "\"player\": {\"feet\": [0, 0, 5]}, \"models\": [{\"id\": \"m\", \"file\": \"" + file
                + "\", \"transform\": [" + step + "]}]";
    }

    /** @param centreAndSize of each in JSON */
    private static String boxes(int count, IntFunction<String> centreAndSize) {
        return IntStream.range(0, count)
                .mapToObj(
                        i -> "{\"id\": \"b" + i + "\", \"kind\": \"box\", \"centre\": " + centreAndSize.apply(i) + "}")
                .collect(Collectors.joining(
                        ",",
                        "\"player\": {\"feet\": [0, 0, 0]}, \"solids\": [{\"id\": \"floor\", \"kind\": \"box\","
                                + " \"centre\": [0, -0.5, 0], \"size\": [20, 1, 20]},",
                        "]"));
    }
}
