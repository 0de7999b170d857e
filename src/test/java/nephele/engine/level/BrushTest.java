package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class BrushTest {
    private static final Vec3 SIZE = new Vec3(2, 1, 4);

    @Test
    void aFaceInheritsWhatItDoesNotSay() {
        var said = Map.of(BoxFace.PLUS_Y, new Solid.Face("tile", null, null));
        Brush brush = Brush.of(new Solid.Box("b", "brick", true, TextureMapping.WORLD, Vec3.ZERO, SIZE, said));
        assertEquals(
                List.of("brick", "brick", "tile", "brick", "brick", "brick"),
                brush.faces().stream().map(Brush.BrushFace::material).toList());
        assertEquals(
                6, brush.faces().stream().filter(Brush.BrushFace::portalable).count());
    }

    @Test
    void aWedgeIsHalfItsBoxAndRisesTowardsTheNamedSide() {
        for (BoxFace rising : List.of(BoxFace.PLUS_X, BoxFace.MINUS_X, BoxFace.PLUS_Z, BoxFace.MINUS_Z)) {
            Brush wedge = Brush.of(
                    new Solid.Wedge("w", null, false, TextureMapping.WORLD, Vec3.ZERO, SIZE, rising, Map.of()));
            assertEquals(5, wedge.faces().size());
            assertEquals(6, wedge.shape().vertices().size());
            assertEquals(Aabb.around(Vec3.ZERO, SIZE), wedge.shape().bounds());
            Vec3 high = rising.normal();
            assertEquals(
                    2,
                    wedge.shape().vertices().stream()
                            .filter(v -> v.y() > 0 && v.x() * high.x() + v.z() * high.z() > 0)
                            .count());
        }
    }

    @Test
    void aPrismReachesItsRadiusAtTheCorners() {
        Brush prism = Brush.of(new Solid.Prism("p", null, false, TextureMapping.WORLD, Vec3.ZERO, 2, 3, 8, Map.of()));
        assertEquals(10, prism.faces().size());
        for (Vec3 v : prism.shape().vertices()) {
            assertEquals(2, Math.sqrt(v.x() * v.x() + v.z() * v.z()), 1e-12);
            assertEquals(1.5, Math.abs(v.y()), 1e-12);
        }
    }

    @Test
    void aBoxWithoutThicknessIsRefused() {
        var flat = new Solid.Box("b", null, false, TextureMapping.WORLD, Vec3.ZERO, new Vec3(1, 0, 1), Map.of());
        assertThrows(IllegalArgumentException.class, () -> Brush.of(flat));
    }
}
