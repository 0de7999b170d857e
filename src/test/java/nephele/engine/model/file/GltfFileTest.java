package nephele.engine.model.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.FolderAssets;
import nephele.engine.asset.ProjectAssets;
import nephele.engine.model.GltfFiles;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GltfFileTest {
    private static final float[] TRIANGLE = {0, 0, 0, 1, 0, 0, 0, 1, 0};

    private static Mesh read(String json) {
        return ModelFiles.read("a.gltf", json.getBytes(StandardCharsets.UTF_8), name -> null);
    }

    @Test
    void anEmbeddedBufferIsRead() {
        Mesh mesh = read(GltfFiles.embedded(""));
        assertArrayEquals(TRIANGLE, mesh.positions());
        assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals());
        assertArrayEquals(new int[] {0, 1, 2}, mesh.indices());
    }

    @Test
    void texturesBeginAtTheBottom() {
        assertArrayEquals(
                new float[] {0, 0, 1, 0, 0, 1}, read(GltfFiles.embedded("")).textureCoordinates());
    }

    @Test
    void aBufferBesideTheFileIsRead() {
        byte[] json = GltfFiles.json("my%20part.bin", "").getBytes(StandardCharsets.UTF_8);
        Mesh mesh = ModelFiles.read("a.gltf", json, name -> name.equals("my part.bin") ? GltfFiles.buffer() : null);
        assertArrayEquals(TRIANGLE, mesh.positions());
    }

    @Test
    void aBinaryFileIsRead() {
        byte[] glb = GltfFiles.binary(GltfFiles.json("", ""), GltfFiles.buffer());
        assertArrayEquals(TRIANGLE, ModelFiles.read("a.glb", glb, name -> null).positions());
    }

    @Test
    void nodesPlaceTheirMeshes() {
        Mesh mesh = read(GltfFiles.embedded(
                ", \"translation\": [1, 2, 3], \"rotation\": [0, 0.70710678, 0, 0.70710678], \"scale\": [2, 1, 1]"));
        assertArrayEquals(new float[] {1, 2, 3, 1, 2, 1, 1, 3, 3}, mesh.positions(), 1e-6f);
        assertArrayEquals(new float[] {1, 0, 0, 1, 0, 0, 1, 0, 0}, mesh.normals(), 1e-6f);
    }

    @Test
    void childrenAreInTheirParentsFrame() {
        String nodes = "\"nodes\": [{ \"children\": [1], \"scale\": [2, 2, 2] }, "
                + "{ \"mesh\": 0, \"translation\": [1, 0, 0] }],";
        Mesh mesh = read(GltfFiles.embedded("").replaceFirst("\"nodes\": \\[\\{ \"mesh\": 0 }],", nodes));
        assertArrayEquals(new float[] {2, 0, 0, 4, 0, 0, 2, 2, 0}, mesh.positions());
    }

    @Test
    void mirroringTurnsTheWindingWithTheNormals() {
        Mesh mesh = read(GltfFiles.embedded(", \"scale\": [-1, 1, 1]"));
        assertArrayEquals(new int[] {0, 2, 1}, mesh.indices());
        assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals(), 1e-6f);
    }

    @Test
    void stripsAndFansBecomeTriangles() {
        for (int mode : new int[] {5, 6}) {
            Mesh mesh = read(GltfFiles.embedded("").replace("\"indices\": 3", "\"mode\": " + mode));
            assertArrayEquals(new int[] {0, 1, 2}, mesh.indices());
        }
    }

    /** All triangles of a strip have one orientation, although every second lists its corners in reverse. */
    @Test
    void aStripsTrianglesLookOneWay() {
        for (boolean mirrored : new boolean[] {false, true}) {
            String four = GltfFiles.embedded(mirrored ? ", \"scale\": [-1, 1, 1]" : "")
                    .replace("\"byteLength\": 6 }", "\"byteLength\": 8 }")
                    .replace("\"count\": 3, \"type\": \"SCALAR\"", "\"count\": 4, \"type\": \"SCALAR\"")
                    .replace("\"indices\": 3", "\"indices\": 3, \"mode\": 5");
            int[] expected = mirrored ? new int[] {0, 2, 1, 1, 2, 0} : new int[] {0, 1, 2, 1, 0, 2};
            assertArrayEquals(expected, read(four).indices());
        }
    }

    @Test
    void missingNormalsAreComputed() {
        Mesh mesh = read(GltfFiles.embedded("").replace("\"NORMAL\": 1,", ""));
        assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals());
    }

    /** A name outside of the grammar is called not allowed, as it is spelled, whether or not the file is there. */
    @Test
    void aNeighbourWhoseNameIsNotAllowedIsToldSo(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("q.gltf"), GltfFiles.json("pe%C3%A7a.bin", ""));
        Files.createDirectory(folder.resolve("scenes"));
        for (AssetSource assets :
                List.of(new FolderAssets(folder), ProjectAssets.around(folder.resolve("scenes/s.xml")))) {
            String file = assets instanceof FolderAssets ? "q.gltf" : "../q.gltf";
            var problem = assertThrows(ModelFileException.class, () -> ModelFiles.read(file, assets, note -> {}));
            assertEquals(
                    file + ": buffers[0].uri names \"peça.bin\", which is not looked up: character 'ç' (U+00E7) is not"
                            + " allowed in an asset id; rename the file, with letters from a to z, digits, '.', '_' and"
                            + " '-'",
                    problem.getMessage());
        }
    }

    @Test
    void nothingIsFetchedFromElsewhere() {
        for (String uri : new String[] {
            "http://a/b.bin", "file:///etc/passwd", "/etc/passwd", "../up.bin", "a/../../up.bin", "%2e%2e/up.bin"
        }) {
            byte[] json = GltfFiles.json(uri, "").getBytes(StandardCharsets.UTF_8);
            var problem = assertThrows(
                    ModelFileException.class, () -> ModelFiles.read("a.gltf", json, name -> GltfFiles.buffer()));
            assertEquals(
                    "a.gltf: buffers[0].uri names no file beside this one; put the buffer there, or embed it",
                    problem.getMessage());
        }
    }

    /** Returns the file with accessor {@code number} of the template replaced. */
    private static String withAccessor(int number, String accessor) {
        String[] lines = GltfFiles.embedded("").split("\n");
        for (int i = 0, at = -1; i < lines.length; i++) {
            at = lines[i].contains("\"accessors\"") ? 0 : at;
            if (at > 0 && at - 1 == number) {
                lines[i] = accessor + (number == 3 ? "]," : ",");
            }
            at += at >= 0 ? 1 : 0;
        }
        return String.join("\n", lines);
    }

    @Test
    void anAccessorWithoutABufferViewHoldsZeros() {
        String zeros = "{ \"componentType\": 5126, \"count\": 3, \"type\": \"VEC2\" }";
        assertArrayEquals(
                new float[] {0, 1, 0, 1, 0, 1}, read(withAccessor(2, zeros)).textureCoordinates());
    }

    /** Sparse values replace elements of a dense accessor, and of zeros. */
    @Test
    void sparseAccessorsReplaceSomeElements() {
        String sparse = ", \"sparse\": { \"count\": 1, \"indices\": { \"bufferView\": 1, \"byteOffset\": 4, "
                + "\"componentType\": 5123 }, \"values\": { \"bufferView\": 0, \"byteOffset\": 12 } } }";
        String dense = "{ \"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"" + sparse;
        assertArrayEquals(
                new float[] {0, 0, 0, 1, 0, 0, 1, 0, 0},
                read(withAccessor(0, dense)).positions());
        String zeros = dense.replace("\"bufferView\": 0, \"componentType\"", "\"componentType\"");
        assertArrayEquals(
                new float[] {0, 0, 0, 0, 0, 0, 1, 0, 0},
                read(withAccessor(0, zeros)).positions());
        for (String wrong : new String[] {"\"count\": 2, \"indices\"", "\"count\": 3, \"indices\""}) {
            String fell = withAccessor(0, dense.replace("\"count\": 1, \"indices\"", wrong));
            var problem = assertThrows(ModelFileException.class, () -> read(fell.replace("104,", "104,")));
            assertEquals("accessors[0].sparse", problem.reason().substring(0, "accessors[0].sparse".length()));
        }
    }

    /** One buffer view of three positions and normals in turn gives what two blocks give. */
    @Test
    void interleavedAttributesAreReadAtTheirStride() {
        Buffer data = new Buffer();
        for (int i = 0; i < 3; i++) {
            data.floats(TRIANGLE[3 * i], TRIANGLE[3 * i + 1], TRIANGLE[3 * i + 2])
                    .floats(0, 0, 1);
        }
        Mesh mesh = read(data.file(
                "\"POSITION\": 0, \"NORMAL\": 1",
                "",
                "{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}, "
                        + "{\"bufferView\": 0, \"byteOffset\": 12, \"componentType\": 5126, \"count\": 3, "
                        + "\"type\": \"VEC3\"}",
                "\"byteStride\": 24, "));
        assertArrayEquals(TRIANGLE, mesh.positions());
        assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals());
    }

    /** Whole numbers stand for what table 3.11.1 says, in texture coordinates and, quantized, everywhere. */
    @Test
    void normalizedAttributesAreSharesOfTheirRange() {
        Map<Integer, Buffer> halves = Map.of(
                5121, new Buffer().bytes(0, 0, 0, 0).bytes(255, 0, 0, 0).bytes(0, 51, 0, 0),
                5123, new Buffer().shorts(0, 0).shorts(65_535, 0).shorts(0, 13_107));
        halves.forEach((component, data) -> {
            int start = data.size();
            data.floats(TRIANGLE);
            Mesh mesh = read(data.file(
                    "\"POSITION\": 0, \"TEXCOORD_0\": 1",
                    "",
                    "{\"bufferView\": 0, \"byteOffset\": " + start
                            + ", \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}, {\"bufferView\": 1, "
                            + "\"componentType\": " + component
                            + ", \"normalized\": true, \"count\": 3, \"type\": \"VEC2\"}",
                    ""));
            assertArrayEquals(new float[] {0, 1, 1, 1, 0, .8f}, mesh.textureCoordinates(), 1e-6f);
        });
    }

    @Test
    void quantizedPositionsAreReadWhereTheExtensionIsUsed() {
        String accessor = "{\"bufferView\": 1, \"componentType\": 5120, \"normalized\": true, \"count\": 3, "
                + "\"type\": \"VEC3\"}";
        Buffer data = new Buffer().bytes(0, 0, 0, 0).bytes(127, 0, 0, 0).bytes(0, -128, 0, 0);
        String quantized = data.file(
                "\"POSITION\": 0",
                "\"extensionsUsed\": [\"KHR_mesh_quantization\"], "
                        + "\"extensionsRequired\": [\"KHR_mesh_quantization\"], ",
                accessor,
                "");
        assertArrayEquals(
                new float[] {0, 0, 0, 1, 0, 0, 0, -1, 0}, read(quantized).positions());
        String plain = data.file("\"POSITION\": 0", "", accessor, "");
        var problem = assertThrows(ModelFileException.class, () -> read(plain));
        assertEquals(
                "accessors[0] has not the type that meshes[0].primitives[0].attributes.POSITION needs",
                problem.reason());
    }

    @Test
    void indicesOfEveryTypeAreRead() {
        Map<Integer, Buffer> all = Map.of(
                5121, new Buffer().bytes(0, 2, 1, 0),
                5123, new Buffer().shorts(0, 2, 1, 0),
                5125, new Buffer().ints(0, 2, 1));
        all.forEach((component, data) -> {
            int start = data.size();
            data.floats(TRIANGLE);
            String file = data.file(
                    "\"POSITION\": 0",
                    "",
                    "{\"bufferView\": 0, \"byteOffset\": " + start
                            + ", \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}, {\"bufferView\": 0, "
                            + "\"componentType\": " + component + ", \"count\": 3, \"type\": \"SCALAR\"}",
                    "");
            Mesh mesh = read(file.replace("\"attributes\"", "\"indices\": 1, \"attributes\""));
            assertArrayEquals(new int[] {0, 2, 1}, mesh.indices());
        });
    }

    @Test
    void aMatrixPlacesItsColumns() {
        Mesh mesh = read(GltfFiles.embedded(", \"matrix\": [0, 2, 0, 0,  -1, 0, 0, 0,  0, 0, 1, 0,  5, 6, 7, 1]"));
        assertArrayEquals(new float[] {5, 6, 7, 5, 8, 7, 4, 6, 7}, mesh.positions());
    }

    @Test
    void theTransformOfTheBaseColourMovesTextureCoordinates() {
        String material = "\"materials\": [{ \"pbrMetallicRoughness\": { \"baseColorTexture\": { \"index\": 0,"
            + " \"extensions\": { \"KHR_texture_transform\": { \"offset\": [0.5, 0.25], \"scale\": [2, 4]EXTRA } } } }"
            + " }], ";
        String file = GltfFiles.embedded("")
                .replace("\"scene\": 0,", "\"scene\": 0, " + material)
                .replace("\"indices\": 3", "\"indices\": 3, \"material\": 0");
        assertArrayEquals(
                new float[] {.5f, -3.25f, 2.5f, -3.25f, .5f, .75f},
                read(file.replace("EXTRA", "")).textureCoordinates());
        var problem = assertThrows(ModelFileException.class, () -> read(file.replace("EXTRA", ", \"rotation\": 1")));
        assertTrue(problem.getMessage().contains("KHR_texture_transform.rotation turns a texture"));
    }

    /** One warning names all that is not applied; a file without it has none. */
    @Test
    void whatIsSkippedIsTold() {
        List<String> notes = new ArrayList<>();
        String file = GltfFiles.embedded(", \"skin\": 0, \"weights\": [0, 1]");
        ModelFiles.read("a.gltf", file.getBytes(StandardCharsets.UTF_8), name -> null, notes::add);
        ModelFiles.read("b.gltf", GltfFiles.embedded("").getBytes(StandardCharsets.UTF_8), name -> null, notes::add);
        assertEquals(
                List.of("a.gltf: its morph targets and skins are not applied, the mesh is shown as it is stored; "
                        + "export it in the pose to be shown"),
                notes);
    }

    @Test
    void requiredExtensionsThatChangeTrianglesAreRefusedByName() {
        for (String name :
                new String[] {"EXT_meshopt_compression", "KHR_draco_mesh_compression", "EXT_mesh_gpu_instancing"}) {
            String file = GltfFiles.embedded("")
                    .replace("\"scene\": 0", "\"scene\": 0, \"extensionsRequired\": [\"" + name + "\"]");
            String message =
                    assertThrows(ModelFileException.class, () -> read(file)).getMessage();
            assertTrue(message.contains("\"" + name + "\""), message);
        }
        read(GltfFiles.embedded("")
                .replace("\"scene\": 0", "\"scene\": 0, \"extensionsRequired\": [\"KHR_texture_basisu\"]"));
    }

    /** A buffer under construction, little-endian, and a file of one mesh over it. */
    private static final class Buffer {
        private final ByteBuffer data = ByteBuffer.allocate(256).order(ByteOrder.LITTLE_ENDIAN);

        int size() {
            return data.position();
        }

        Buffer floats(float... values) {
            for (float value : values) {
                data.putFloat(value);
            }
            return this;
        }

        Buffer ints(int... values) {
            for (int value : values) {
                data.putInt(value);
            }
            return this;
        }

        Buffer shorts(int... values) {
            for (int value : values) {
                data.putShort((short) value);
            }
            return this;
        }

        Buffer bytes(int... values) {
            for (int value : values) {
                data.put((byte) value);
            }
            return this;
        }

        /** Returns the file; buffer view 0 is all of the buffer, view 1 too, in elements of 4 bytes. */
        String file(String attributes, String top, String accessors, String stride) {
            byte[] bytes = Arrays.copyOf(data.array(), data.position());
            String view = "\"buffer\": 0, \"byteLength\": " + bytes.length;
            return "{\"asset\": {\"version\": \"2.0\"}, " + top
                    + "\"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}], "
                    + "\"meshes\": [{\"primitives\": [{\"attributes\": {" + attributes + "}}]}], "
                    + "\"accessors\": [" + accessors + "], "
                    + "\"bufferViews\": [{" + stride + view + "}, {\"byteStride\": 4, " + view + "}], "
                    + "\"buffers\": [{\"byteLength\": " + bytes.length
                    + ", \"uri\": \"data:application/octet-stream;base64,"
                    + Base64.getEncoder().encodeToString(bytes) + "\"}]}";
        }
    }
}
