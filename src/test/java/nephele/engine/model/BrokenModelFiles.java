package nephele.engine.model;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * A file that is not a valid mesh.
 *
 * @param name describes the defect and ends in the file's extension
 * @param where beginning of the message after the file name: the line, or for JSON and binary data the path
 */
record BrokenModelFiles(String name, byte[] bytes, String where) {
    private static final String POINTS = "0 0 0\n1 0 0\n0 1 0\n";
    private static final String PATCH_HEAD = "1\n0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n";
    private static final String OBJ_POINTS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    static Stream<BrokenModelFiles> all() {
        return Stream.of(texts(), patches(), objects(), gltf(), binary(), large())
                .flatMap(part -> part);
    }

    @Override
    public String toString() {
        return name;
    }

    private static BrokenModelFiles of(String name, String text, String where) {
        return new BrokenModelFiles(name, text.getBytes(UTF_8), where);
    }

    private static Stream<BrokenModelFiles> texts() {
        return Stream.of(
                of("empty.3d", "", ": "),
                of("white.3d", " \n\t\n", ":2: "),
                of("words.3d", "hello world again\n", ":1: "),
                of("nan.3d", "0 0 NaN\n1 0 0\n0 1 0\n", ":1: "),
                of("infinite.3d", POINTS + "\n0 0 1e999\n0 0 1\n0 0 1\n", ":5: "),
                of("far.3d", "0 0 0\n1 0 0\n0 1e30 0\n", ":3: "),
                of("farther.3d", "0 0 0\n1 0 0\n0 2000000 0\n", ":3: 2000000 is no coordinate; "),
                of("comma.3d", "0,5 0 0\n", ":1: "),
                of("hexadecimal.3d", "0x1p3 0 0\n", ":1: "),
                of("two-points.3d", "0 0 0\n1 0 0\n", ":2: "),
                of("too-few.3d", "4\n" + POINTS, ":1: "),
                of("too-many.3d", "2\n" + POINTS, ":1: "),
                of("count-of-minus-one.3d", "-1\n" + POINTS, ":1: "),
                of("count-of-billions.3d", "2000000000\n" + POINTS, ":1: 2000000000 is no number of rows; "),
                of("a-number-missing.3d", "0 0 0\n1 0\n0 1 0\n", ":2: "),
                of("four-numbers.3d", "0 0 0 1\n", ":1: "),
                of("texture-first.3d", "0 0\n1 0\n0 1\n", ":1: "),
                of("fewer-normals.3d", POINTS + "\n0 0 1\n0 0 1\n\n0 0\n0 0\n0 0\n", ":5: "),
                of("fewer-textures.3d", POINTS + "\n0 0\n1 0\n", ":5: "),
                of("index-beyond.3d", POINTS + "\n0 1 2\n0 2 3\n", ":6: 3 names no point; "),
                of("index-negative.3d", POINTS + "\n0 0 1\n0 0 1\n0 0 1\n\n0 1 -2\n", ":9: -2 names no point; "),
                of("index-half.3d", POINTS + "\n0 0 1\n0 0 1\n0 0 1\n\n0 1 1.5\n", ":9: 1.5 names no point; "),
                of("two-indices.3d", POINTS + "\n0\n1\n", ":6: "),
                of("after-the-end.3d", POINTS + "\n" + POINTS + "\n0 0\n0 0\n0 0\n\n0 1 2\n\n0 1 2\n", ":15: "),
                of("many-blocks.3d", (POINTS + "\n").repeat(20), ":"),
                of("wide.3d", "1 ".repeat(5000), ":1: "),
                of("long-word.3d", "1".repeat(10_000) + " 0 0", ":1: "),
                of("zeros.3d", "\0".repeat(1000), ":1: "));
    }

    private static Stream<BrokenModelFiles> patches() {
        String points = "0,0,0\n".repeat(16);
        return Stream.of(
                of("empty.patch", "", ": "),
                of("no-patches.patch", "0\n16\n" + points, ":1: "),
                of("negative.patch", "-1\n", ":1: "),
                of("billions.patch", "2000000000\n", ":1: "),
                of("half.patch", "1.5\n", ":1: "),
                of("fifteen-indices.patch", "1\n0,1,2,3,4,5,6,7,8,9,10,11,12,13,14\n16\n" + points, ":2: "),
                of("index-beyond.patch", PATCH_HEAD.replace("15", "16") + "16\n" + points, ":2: "),
                of("index-negative.patch", PATCH_HEAD.replace("15", "-1") + "16\n" + points, ":2: "),
                of("index-word.patch", PATCH_HEAD.replace("15", "x") + "16\n" + points, ":2: "),
                of("ends-early.patch", PATCH_HEAD, ":2: "),
                of("point-missing.patch", PATCH_HEAD + "17\n" + points, ":19: "),
                of("point-more.patch", PATCH_HEAD + "16\n" + points + "0,0,0\n", ":20: "),
                of("point-flat.patch", PATCH_HEAD + "16\n0,0\n", ":4: "),
                of("point-nan.patch", PATCH_HEAD + "16\n0,0,NaN\n", ":4: "));
    }

    private static Stream<BrokenModelFiles> objects() {
        return Stream.of(
                of("empty.obj", "", ": "),
                of("no-faces.obj", OBJ_POINTS, ":3: "),
                of("flat-faces.obj", OBJ_POINTS + "f 1 2 2\n", ":4: "),
                of("two-numbers.obj", "v 1 2\n", ":1: "),
                of("eight-numbers.obj", "v 1 2 3 4 5 6 7 8\n", ":1: "),
                of("nan.obj", "v 0 0 nan\n", ":1: "),
                of("far.obj", "v 0 0 1e38\n", ":1: "),
                of("two-corners.obj", OBJ_POINTS + "f 1 2\n", ":4: "),
                of("index-zero.obj", OBJ_POINTS + "f 0 1 2\n", ":4: "),
                of("index-beyond.obj", OBJ_POINTS + "f 1 2 4\n", ":4: "),
                of("index-too-negative.obj", OBJ_POINTS + "f -1 -2 -4\n", ":4: "),
                of("index-huge.obj", OBJ_POINTS + "f 1 2 99999999999\n", ":4: "),
                of("index-minimum.obj", OBJ_POINTS + "f 1 2 -2147483648\n", ":4: "),
                of("texture-beyond.obj", OBJ_POINTS + "f 1/1 2/1 3/1\n", ":4: "),
                of("normal-beyond.obj", OBJ_POINTS + "f 1//1 2//1 3//1\n", ":4: "),
                of("normal-missing.obj", OBJ_POINTS + "vt 0 0\nf 1/1/ 2/1/ 3/1/\n", ":5: "),
                of("four-parts.obj", OBJ_POINTS + "f 1/1/1/1 2 3\n", ":4: "),
                of("smoothing.obj", "s many\n", ":1: "),
                of("curves.obj", "curv 0 1 1 2 3\n", ":1: "),
                of("picture.obj", "\u0089PNG\r\n", ":1: "));
    }

    private static BrokenModelFiles gltf(String name, String from, String to, String where) {
        String good = GltfFiles.embedded("");
        if (!good.contains(from)) {
            throw new IllegalArgumentException(name);
        }
        return of(name, good.replace(from, to), where);
    }

    private static Stream<BrokenModelFiles> gltf() {
        return Stream.of(
                of("empty.gltf", "", ":1: "),
                of("array.gltf", "[]", ": "),
                of("null.gltf", "null", ": "),
                of("deep.gltf", "[".repeat(100_000), ":1: "),
                of("truncated.gltf", GltfFiles.embedded("").substring(0, 300), ":"),
                of("comment.gltf", "{\n// no\n}", ":2: "),
                gltf("version.gltf", "\"2.0\"", "\"1.0\"", ": asset.version "),
                gltf("scene.gltf", "\"scene\": 0", "\"scene\": 1", ": scene "),
                gltf("no-nodes.gltf", "[{ \"nodes\": [0] }]", "[{ \"nodes\": [] }]", ": "),
                gltf("node-beyond.gltf", "\"nodes\": [0]", "\"nodes\": [7]", ": scenes[0].nodes[0] "),
                gltf("node-twice.gltf", "\"nodes\": [0]", "\"nodes\": [0, 0]", ": scenes[0].nodes[1] "),
                gltf("cycle.gltf", "{ \"mesh\": 0 }", "{ \"mesh\": 0, \"children\": [0] }", ": nodes[0].children[0] "),
                gltf("mesh-beyond.gltf", "{ \"mesh\": 0 }", "{ \"mesh\": 3 }", ": nodes[0].mesh "),
                gltf("mesh-negative.gltf", "{ \"mesh\": 0 }", "{ \"mesh\": -1 }", ": nodes[0].mesh "),
                gltf("frame.gltf", "{ \"mesh\": 0 }", "{ \"mesh\": 0, \"scale\": [1] }", ": nodes[0].scale "),
                gltf("far.gltf", "{ \"mesh\": 0 }", "{ \"mesh\": 0, \"scale\": [1e30, 1, 1] }", ": "),
                gltf("frame-1e999.gltf", "{ \"mesh\": 0 }", "{ \"mesh\": 0, \"scale\": [1e999, 1, 1] }", ": nodes[0]."),
                gltf("points.gltf", "\"indices\": 3", "\"mode\": 0", ": "),
                gltf("mode.gltf", "\"indices\": 3", "\"mode\": 7", ": meshes[0].primitives[0].mode "),
                gltf("no-position.gltf", "\"POSITION\": 0, ", "", ": meshes[0].primitives[0].attributes.POSITION "),
                gltf(
                        "billions.gltf",
                        "\"count\": 3, \"type\": \"VEC3\" }",
                        "\"count\": 2000000000, \"type\": \"VEC3\" }",
                        ": accessors[0].count "),
                gltf(
                        "beyond.gltf",
                        "\"count\": 3, \"type\": \"VEC3\" }",
                        "\"count\": 4000, \"type\": \"VEC3\" }",
                        ": accessors[0] "),
                gltf(
                        "unequal.gltf",
                        "\"count\": 3, \"type\": \"VEC2\"",
                        "\"count\": 2, \"type\": \"VEC2\"",
                        ": meshes[0].primitives[0].attributes.TEXCOORD_0 "),
                gltf("type.gltf", "\"type\": \"SCALAR\"", "\"type\": \"VEC2\"", ": accessors[3] "),
                gltf("component.gltf", "\"componentType\": 5123", "\"componentType\": 5126", ": accessors[3] "),
                gltf(
                        "sparse.gltf",
                        "\"count\": 3, \"type\": \"SCALAR\"",
                        "\"count\": 3, \"type\": \"SCALAR\", \"sparse\": {}",
                        ": accessors[3].sparse "),
                gltf("unaligned.gltf", "\"byteOffset\": 36", "\"byteOffset\": 35", ": accessors[1] "),
                gltf("view.gltf", "\"byteOffset\": 96", "\"byteOffset\": 2147483647", ": bufferViews[1] "),
                gltf("stride.gltf", "\"byteLength\": 96", "\"byteStride\": 8, \"byteLength\": 96", ": accessors[0] "),
                gltf("short-buffer.gltf", "\"byteLength\": 104", "\"byteLength\": 105", ": buffers[0].byteLength "),
                gltf("base64.gltf", "base64,", "base64,%", ": buffers[0].uri "),
                gltf("percent.gltf", "data:application/octet-stream;base64,", "%zz", ": buffers[0].uri "),
                of("missing.gltf", GltfFiles.json("gone.bin", ""), ": buffers[0].uri "),
                of("no-binary.gltf", GltfFiles.json("", ""), ": buffers[0].uri "),
                gltf("index-beyond.gltf", "\"indices\": 3", "\"indices\": 4", ": meshes[0].primitives[0].indices "),
                gltf(
                        "draco.gltf",
                        "\"scene\": 0",
                        "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]",
                        ": extensionsRequired[0] "));
    }

    private static Stream<BrokenModelFiles> binary() {
        byte[] good = GltfFiles.binary(GltfFiles.json("", ""), GltfFiles.buffer());
        byte[] index = good.clone();
        index[good.length - 8] = 9;
        return Stream.of(
                new BrokenModelFiles("header.glb", Arrays.copyOf(good, 10), ": byte 10: "),
                new BrokenModelFiles("truncated.glb", Arrays.copyOf(good, good.length - 1), ": byte 8: "),
                new BrokenModelFiles("version.glb", changed(good, 4, 1), ": byte 4: "),
                new BrokenModelFiles("chunk.glb", changed(good, 16, 0), ": byte 16: "),
                new BrokenModelFiles("long-chunk.glb", changed(good, 15, 127), ": byte 12: "),
                new BrokenModelFiles("negative-chunk.glb", changed(good, 15, -1), ": byte 12: "),
                new BrokenModelFiles("index.glb", index, ": index 9 "),
                new BrokenModelFiles(
                        "nan.glb", changed(changed(good, good.length - 101, 127), good.length - 102, -64), ": NaN "),
                new BrokenModelFiles("unknown.fbx", good, ": "));
    }

    private static byte[] changed(byte[] bytes, int at, int value) {
        byte[] copy = bytes.clone();
        copy[at] = (byte) value;
        return copy;
    }

    /** Returns files that would take long or exhaust the memory. */
    private static Stream<BrokenModelFiles> large() {
        var spikes = new StringBuilder();
        var face = new StringBuilder("f");
        for (int i = 0; i < 4000; i++) {
            spikes.append("v " + (i % 2 == 0 ? i : -i) + " " + i * 7919 % 4000 + " 0\n");
            face.append(' ').append(i + 1);
        }
        return Stream.of(
                of("millions-of-values.gltf", "[" + "0,".repeat(300_000) + "0]", ":1: "),
                of("jagged.obj", spikes + (face + "\n").repeat(50), ":40"),
                of(
                        "corners-4097.obj",
                        OBJ_POINTS + "f" + " 1 2 3".repeat(1365) + " 1 2\n",
                        ":4: a face has 4097 corners"),
                of("long-face.obj", OBJ_POINTS + "f" + " 1".repeat(100_000), ":4: "),
                of("too-large.3d", "#".repeat(MeshLimits.MAX_TEXT_BYTES + 1), ": "),
                of("too-large.obj", "#".repeat(MeshLimits.MAX_TEXT_BYTES + 1), ": "),
                new BrokenModelFiles("too-large.gltf", new byte[MeshLimits.MAX_GLTF_BYTES + 1], ": "));
    }
}
