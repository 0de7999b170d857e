package nephele.engine.model.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import nephele.engine.model.ModelFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GeneratedNameTest {
    private static Optional<Shape> shape(String name) {
        return GeneratedName.shape(name, neighbour -> null);
    }

    @Test
    void namesAreTheShapesThatTheGeneratorMakes() {
        assertEquals(new PlaneShape(2, 3, false), shape("plane_2_3.3d").orElseThrow());
        assertEquals(new BoxShape(2, 3), shape("models/box_2_3.3d").orElseThrow());
        assertEquals(new ConeShape(1, 2, 4, 3), shape("cone_1_2_4_3.3d").orElseThrow());
        assertEquals(new SphereShape(0.5, 8, 8), shape("..\\sphere_0.5_8_8.3d").orElseThrow());
        assertEquals(new CylinderShape(1, 2, 8), shape("cylinder_1_2_8.3d").orElseThrow());
        assertEquals(new TorusShape(1, 0.3, 16, 8), shape("torus_1_0.3_16_8.3d").orElseThrow());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"sphere.3d", "sphere_1_8_8.obj", "ball_1_8_8.3d", "sphere_a_8_8.3d", "xsphere_1_8_8.3d", ""})
    void otherNamesAreNone(String name) {
        assertEquals(Optional.empty(), shape(name));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "box_2.3d",
                "box_2_0.3d",
                "sphere_1_8_1000000.3d",
                "cone_0_2_4_3.3d",
                "bezier_1_2.3d",
                "bezier_0.3d",
                "bezier_512.3d",
                "plane_1.2.3_4.3d"
            })
    void numbersThatMakeNoShapeAreRefusedByFile(String name) {
        var problem = assertThrows(ModelFileException.class, () -> shape(name));
        assertTrue(problem.getMessage().startsWith(name + ": "), problem.getMessage());
    }

    @ParameterizedTest
    @CsvSource({
        "plane_2_3.3d, 0",
        "box_2_3.3d, 0",
        "cone_1_2_4_3.3d, 0",
        "sphere_0.5_8_8.3d, 0",
        "cylinder_1_2_8.3d, 0",
        "torus_1_0.3_16_8.3d, 0",
        "bezier_10.3d, 80"
    })
    void trianglesAreCountedBeforeTheyAreMade(String name, int withoutArea) {
        Shape shape = shape(name).orElseThrow();
        assertEquals(shape.maxTriangles(), shape.mesh().triangleCount() + withoutArea);
    }

    @Test
    void theTeapotShips() {
        assertEquals(32 * 11 * 11, shape("bezier_10.3d").orElseThrow().mesh().vertexCount());
    }

    @Test
    void aTeapotBesideTheSceneComesFirst() {
        String own = "1\n0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n16\n" + "1,2,3\n".repeat(16);
        var shape = GeneratedName.shape(
                "bezier_10.3d", name -> name.equals("teapot.patch") ? own.getBytes(StandardCharsets.UTF_8) : null);
        assertEquals(11 * 11, shape.orElseThrow().mesh().vertexCount());
    }
}
