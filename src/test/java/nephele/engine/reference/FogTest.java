package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The reference fog is mix(fog, c, exp(−k d)), with the length d of the eye ray's whole path. */
class FogTest {
    private static final Vec3 EYE = new Vec3(0, 0, 2);
    private static final double WHITE = 0.8;
    private static final Vec3 FOG = new Vec3(0.1, 0.5, 3);

    private static TestLevel stage(double extinctionPerMetre) {
        return new TestLevel()
                .skyLight()
                .fog(extinctionPerMetre, FOG)
                .sky(new Sky.Constant(TestLevel.grey(7)))
                .ambient(1)
                .material("white", TestLevel.grey(WHITE));
    }

    private static void assertFog(double thickness, float[] seen) {
        double left = Math.exp(-thickness);
        assertEquals(FOG.x() + (WHITE - FOG.x()) * left, seen[0], 1e-6);
        assertEquals(FOG.y() + (WHITE - FOG.y()) * left, seen[1], 1e-6);
        assertEquals(FOG.z() + (WHITE - FOG.z()) * left, seen[2], 1e-6);
    }

    @Test
    void aWallFadesByItsDistance() {
        for (double thickness : new double[] {0, 1, 100}) {
            TestLevel wall = stage(thickness / 5).box("white", new Vec3(0, 0, -4), new Vec3(9, 9, 2));
            assertFog(thickness, Traced.towards(wall, EYE, new Vec3(0, 0, -3), 1));
            double slanted = Math.sqrt(5 * 5 + 1);
            assertFog(thickness / 5 * slanted, Traced.towards(wall, EYE, new Vec3(1, 0, -3), 1));
        }
    }

    /** 2 m to the portal, 3 m behind it. */
    @Test
    void theDistanceCountsThroughPortals() {
        TestLevel pair = stage(0.3)
                .box("white", new Vec3(0, 0, -5), new Vec3(13, 6, 10))
                .box("white", new Vec3(100, 0, -4), new Vec3(9, 9, 2))
                .portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), 1, 2)
                .portal("b", "a", new Vec3(100, 0, 0), new Vec3(0, 0, -1), 1, 2);
        assertFog(0.3 * 5, Traced.towards(pair, EYE, Vec3.ZERO, 1));
        assertFog(0.3 * 2, Traced.towards(pair, new Vec3(2, 0, 2), new Vec3(2, 0, 0), 1));
    }

    @Test
    void throughFogTheSkyIsNotSeen() {
        assertEquals(FOG.y(), Traced.towards(stage(1e-9), EYE, Vec3.ZERO, 1)[1], 1e-6);
        assertEquals(7, Traced.towards(stage(0), EYE, Vec3.ZERO, 1)[1], 1e-6);
    }
}
