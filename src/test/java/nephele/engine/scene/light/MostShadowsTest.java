package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Only the most powerful lights keep their shadows when quality allows few. */
class MostShadowsTest {
    private static PunctualLight lamp(String id, double intensity, boolean castsShadow) {
        var power = new Vec3(intensity, intensity, intensity);
        return PunctualLight.of(new Light.Point(id, Vec3.ZERO, power, 5.0, castsShadow))
                .orElseThrow();
    }

    private static final LightShadowLayers THREE = LightShadowLayers.of(
            List.of(lamp("weak", 1, true), lamp("dark", 9, false), lamp("strong", 5, true), lamp("middle", 3, true)));

    @Test
    void theStrongestKeepTheirs() {
        assertArrayEquals(new int[] {12, -1, 0, 6}, THREE.firstLayer());
        LightShadowLayers two = THREE.ofMostPowerful(2);
        assertArrayEquals(new int[] {-1, -1, 0, 6}, two.firstLayer());
        assertEquals(THREE.layers().subList(0, 12), two.layers());
        assertEquals(THREE.side(), two.side());
    }

    @Test
    void enoughForAllChangesNothing() {
        assertSame(THREE, THREE.ofMostPowerful(3));
        assertSame(THREE, THREE.ofMostPowerful(999));
    }

    @Test
    void noneLeavesNoLayer() {
        assertArrayEquals(new int[] {-1, -1, -1, -1}, THREE.ofMostPowerful(0).firstLayer());
        assertEquals(List.of(), THREE.ofMostPowerful(0).layers());
    }
}
