package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class SphereShapeTest {
    @Test
    void aNameIsTheShapeItStandsFor() {
        Shape shape = GeneratedName.shape("a/sphere_1_8_8.3d", name -> null).orElseThrow();
        assertEquals(new SphereShape(1, 8, 8), shape);
        assertEquals(2 * 8 * 7, shape.mesh().triangleCount());
        assertArrayEquals(
                shape.mesh().positions(), new SphereShape(1, 8, 8).mesh().positions());
    }

    @Test
    void theTeapotShips() {
        Shape teapot = GeneratedName.shape("bezier_10.3d", name -> null).orElseThrow();
        assertEquals(32 * 11 * 11, teapot.mesh().vertexCount());
    }
}
