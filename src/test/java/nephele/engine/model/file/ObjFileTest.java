package nephele.engine.model.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshTexts;
import nephele.engine.model.Triangles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ObjFileTest {
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    private static Mesh read(String text) {
        return ModelFiles.read("a.obj", text.getBytes(StandardCharsets.UTF_8), name -> null);
    }

    /** Returns the area of all triangles projected along z, positive for those that face +z. */
    private static double area(Mesh mesh) {
        double sum = 0;
        for (int i = 0; i < mesh.indices().length; i += 3) {
            sum += Triangles.normal(mesh, i).z / 2;
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "f 1 2 3 4",
                "f -4 -3 -2 -1",
                "f 1 2 \\\n3 4",
                "f 1 2 3\\\n4",
                "o square\ng a b\nusemtl steel\nmtllib none.mtl\ns 1\nf 1 2 3 4",
                "# faces\r\nf 1 2 3 4 # all\r\n"
            })
    void aSquareIsTwoTriangles(String face) {
        for (String text : new String[] {SQUARE + face, (SQUARE + face).replaceAll("\r?\n", "\r\n")}) {
            Mesh mesh = read(text);
            assertEquals(2, mesh.triangleCount());
            assertEquals(4, mesh.vertexCount());
            assertEquals(1, area(mesh), 1e-12);
            assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals());
        }
    }

    /** A concave decagon is filled correctly in any plane, in either order, from any corner. */
    @Test
    void aConcavePolygonIsFilledAndNotItsHull() {
        double[][] star = new double[10][];
        for (int i = 0; i < 10; i++) {
            double r = i % 2 == 0 ? 2 : 0.5;
            star[i] = new double[] {r * Math.cos(i * Math.PI / 5), r * Math.sin(i * Math.PI / 5)};
        }
        double area = 5 * 2 * 0.5 * Math.sin(Math.PI / 5);
        for (int start = 0; start < 10; start++) {
            for (int way : new int[] {1, -1}) {
                StringBuilder text = new StringBuilder();
                for (int i = 0; i < 10; i++) {
                    double[] corner = star[Math.floorMod(start + way * i, 10)];
                    text.append("v " + corner[0] + " " + corner[1] + " " + corner[1] + "\n");
                }
                Mesh mesh = read(text + "f 1 2 3 4 5 6 7 8 9 10\n");
                assertEquals(8, mesh.triangleCount());
                assertEquals(way * area, area(mesh), 1e-6);
                for (int i = 0; i < mesh.indices().length; i += 3) {
                    assertTrue(way * Triangles.normal(mesh, i).z > 0);
                }
            }
        }
    }

    @Test
    void cornersShareAVertexWhereAllIsEqual() {
        Mesh mesh = read(SQUARE + "vt 0 0\nvt 1 1\nvn 0 0 2\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/2/1");
        assertEquals(4, mesh.vertexCount());
        assertArrayEquals(new float[] {0, 0, 0, 0, 0, 0, 1, 1}, mesh.textureCoordinates());
        assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals());
    }

    @Test
    void smoothingJoinsNormalsOverATextureSeamAndOffKeepsThemApart() {
        String roof = "v 0 0 0\nv 0 0 1\nv -1 -1 0\nv -1 -1 1\nv 1 -1 0\nv 1 -1 1\nvt 0 0\nvt 1 0\n";
        String faces = "f 1/1 3/1 4/1 2/1\nf 1/2 2/2 6/2 5/2\n";
        Mesh smooth = read(roof + faces);
        assertArrayEquals(
                new float[] {0, 1, 0},
                new float[] {smooth.normals()[0], smooth.normals()[1], smooth.normals()[2]},
                1e-6f);
        Mesh flat = read(roof + "s off\n" + faces);
        float half = (float) Math.sqrt(0.5);
        assertArrayEquals(
                new float[] {-half, half, 0},
                new float[] {flat.normals()[0], flat.normals()[1], flat.normals()[2]},
                1e-6f);
    }

    @Test
    void aPolygonMayHaveUpTo4096Corners() {
        assertEquals(4094, read(MeshTexts.polygon(4096)).triangleCount());
        String twoLines = MeshTexts.polygon(4096).replace(" 2000 ", " 2000 \\\n");
        assertEquals(4094, read(twoLines).triangleCount());
    }

    /** A backslash at the end of the file continues with nothing. */
    @ParameterizedTest
    @ValueSource(strings = {"f 1 2 3 \\", "f 1 2 3\\", "f 1 2 3 \\\n", "f 1 2 3\n\\", "f 1 2 3\\\\\n# end"})
    void aBackslashMayEndTheFile(String face) {
        assertEquals(1, read(SQUARE + face).triangleCount());
    }

    @Test
    void aTriangleWithoutAreaIsLeftOut() {
        assertEquals(1, read(SQUARE + "f 1 2 3\nf 1 1 2\n").triangleCount());
    }

    @Test
    void aColourAfterAPointIsSkipped() {
        assertEquals(
                1, read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3").triangleCount());
    }
}
