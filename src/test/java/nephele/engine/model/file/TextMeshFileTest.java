package nephele.engine.model.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.shape.BoxShape;
import nephele.engine.model.shape.ConeShape;
import nephele.engine.model.shape.CylinderShape;
import nephele.engine.model.shape.GeneratedName;
import nephele.engine.model.shape.PlaneShape;
import nephele.engine.model.shape.Shape;
import nephele.engine.model.shape.SphereShape;
import nephele.engine.model.shape.TorusShape;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class TextMeshFileTest {
    private static final String POINTS = "0 0 0\n1 0 0\n0 1 0\n";
    private static final String NORMALS = "0 0 1\n0 0 1\n0 0 1\n";
    private static final String TEXTURE = "0 0\n1 0\n0 1\n";

    private static Mesh read(String text) {
        return ModelFiles.read("a.3d", text.getBytes(StandardCharsets.UTF_8), name -> null);
    }

    private static void assertBitEqual(Mesh wanted, Mesh mesh) {
        assertArrayEquals(wanted.positions(), mesh.positions());
        assertArrayEquals(wanted.normals(), mesh.normals());
        assertArrayEquals(wanted.textureCoordinates(), mesh.textureCoordinates());
        assertArrayEquals(wanted.indices(), mesh.indices());
    }

    /** Reading stops at the limit, as in OBJ files; an oversized mesh is not collected first. */
    @Test
    void readingEndsAtTheFirstPointTooMany() {
        String endless = "0 0 0\n".repeat(MeshLimits.MAX_VERTICES + 10);
        var problem = assertThrows(ModelFileException.class, () -> read(endless));
        assertEquals(MeshLimits.MAX_VERTICES + 1, problem.line(), problem.getMessage());
    }

    @Test
    void aByteOrderMarkIsNoNumber() {
        assertBitEqual(read(POINTS), read("\ufeff" + POINTS));
    }

    @Test
    void whatIsWrittenIsReadBackToTheLastBit() {
        var teapot = GeneratedName.shape("bezier_5.3d", name -> null).orElseThrow();
        for (Shape shape : new Shape[] {
            new PlaneShape(0.3, 7, true),
            new BoxShape(1e-6, 3),
            new ConeShape(0.1, 1e6, 7, 3),
            new SphereShape(1 / 3.0, 31, 17),
            new CylinderShape(0.7, 3, 11),
            new TorusShape(1e3, 0.1, 9, 13),
            teapot
        }) {
            Mesh mesh = shape.mesh();
            assertBitEqual(mesh, ModelFiles.read("a.3d", MeshText.of(mesh), name -> null));
        }
    }

    /** 10⁶ random bit patterns, in and beyond the range of coordinates, read back equal. */
    @Test
    void theTextOfAFloatReadsBackToIt() {
        var random = new SplittableRandom(48);
        for (int i = 0; i < 1_000_000; i++) {
            float value = Float.intBitsToFloat(random.nextInt());
            if (Float.isFinite(value)) {
                String text = MeshText.number(value);
                assertEquals(Float.floatToRawIntBits(value), Float.floatToRawIntBits(Float.parseFloat(text)), text);
            }
        }
        assertEquals("-0", MeshText.number(-0f));
        assertEquals("0.1", MeshText.number(0.1f));
        assertEquals("0.33333334", MeshText.number(1 / 3f));
        assertEquals("1000000", MeshText.number(1e6f).replace("1E+6", "1000000"));
    }

    /** All variants in which course projects write one triangle give the same mesh. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                POINTS,
                "3\n" + POINTS,
                POINTS + "\n" + NORMALS,
                POINTS + "\n" + TEXTURE,
                POINTS + "\n" + NORMALS + "\n" + TEXTURE,
                POINTS + "\n0 1 2\n",
                POINTS + "\n" + NORMALS + "\n" + TEXTURE + "\n0 1 2\n",
                POINTS + "\n\n\n" + NORMALS + "\n" + TEXTURE + "\n0\n1\n2\n",
                "3\n" + POINTS + "3\n" + NORMALS + "3\n" + TEXTURE + "1\n0 1 2",
                "3\n" + POINTS + "\n3\n" + NORMALS + "\n3\n" + TEXTURE + "\n3\n0\n1\n2\n",
                "# a triangle\n0, 0, 0\n1; 0; 0 # the second point\n\t 0 1.0e0   -0\n",
                POINTS + "\n" + NORMALS + "\n0 1 2\n"
            })
    void everyVariantOfATriangleIsRead(String text) {
        for (String ending : new String[] {"\n", "\r\n", "\r"}) {
            Mesh mesh = read(text.replace("\n", ending));
            assertArrayEquals(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, mesh.positions(), 0);
            assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1}, mesh.normals());
            assertArrayEquals(new int[] {0, 1, 2}, mesh.indices());
            assertEquals(text.contains(TEXTURE) ? 1 : 0, mesh.textureCoordinates()[2]);
        }
    }

    @Test
    void normalsOfOtherLengthsBecomeUnit() {
        Mesh mesh = read(POINTS + "\n0 0 5\n0 0 0\n0 3 4\n\n0 1 2\n");
        assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0.6f, 0.8f}, mesh.normals());
    }
}
