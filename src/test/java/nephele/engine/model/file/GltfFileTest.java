package nephele.engine.model.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import nephele.engine.model.GltfFiles;
import nephele.engine.model.Mesh;
import nephele.engine.model.ModelFileException;
import org.junit.jupiter.api.Test;

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
}
