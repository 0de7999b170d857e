package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import nephele.engine.asset.TestAssets;
import nephele.engine.atmosphere.AerialTable;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirLight;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.AirOfEnvironment;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Surfaces under an atmosphere are seen through its air. */
class AerialPerspectiveGlTest {
    private static final int SIDE = 15;
    private static final int MIDDLE = 3 * (SIDE * SIDE / 2);
    private static final double IRRADIANCE = 1000;
    private static final Vec3 GLOW = new Vec3(20, 10, 5);
    private static final AirTables CLEAR = AirTables.of(Air.CLEAR);

    private static TestLevel glowing(Vec3 towardsSun) {
        return new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(towardsSun, IRRADIANCE)
                .material(new Material("glow", Vec3.ZERO, null, null, null, null, GLOW, 1));
    }

    private static View view(Vec3 eye, Vec3 target) {
        return View.lookAt(eye, target, new Vec3(0, 1, 0), new Projection(Math.PI / 2, 1, 0.05, 2e5));
    }

    /** Walls that fill the picture, at four distances; the upper half of the picture is above the horizon. */
    @ParameterizedTest
    @ValueSource(doubles = {50, 1, -3})
    void theShaderIsTheTableAtEveryPixel(double sunDegrees) {
        double elevation = Math.toRadians(sunDegrees);
        Vec3 sun = new Vec3(0.6 * Math.cos(elevation), Math.sin(elevation), -0.8 * Math.cos(elevation));
        AerialTable table = new AerialTable(CLEAR, 2, sun.y());
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            for (double metres : new double[] {5, 700, 9_000, 60_000}) {
                Level wall = glowing(sun)
                        .box("glow", new Vec3(0, 0, -1.5 * metres), new Vec3(3 * metres, 3 * metres, metres))
                        .level();
                Vec3 eye = new Vec3(0, 2, 0);
                float[] seen = offscreen.radiance(wall, TestAssets.NONE, view(eye, new Vec3(0, 2, -1)));
                for (int i = 0; i < SIDE * SIDE; i++) {
                    double x = (2 * (i % SIDE) + 1.0) / SIDE - 1;
                    double y = (2 * (i / SIDE) + 1.0) / SIDE - 1;
                    double length = Math.sqrt(x * x + y * y + 1);
                    Vec3 away = new Vec3(x / length, y / length, -1 / length);
                    assertSeen(table.along(away, sun, length * metres), seen, 3 * i, metres + " m, " + away);
                }
            }
        }
    }

    private static void assertSeen(AirLight air, float[] seen, int at, String where) {
        Vec3 light = air.radiance();
        Vec3 left = air.transmittance();
        assertEquals(1, seen[at] / (IRRADIANCE * light.x() + left.x() * GLOW.x()), 2e-3, where);
        assertEquals(1, seen[at + 1] / (IRRADIANCE * light.y() + left.y() * GLOW.y()), 2e-3, where);
        assertEquals(1, seen[at + 2] / (IRRADIANCE * light.z() + left.z() * GLOW.z()), 2e-3, where);
    }

    /** The portals are 4 km apart in height, so both views have tables of their own. */
    @Test
    void throughAPortalTheAirIsThatOfTheMovedEye() {
        Level level = glowing(new Vec3(0.6, 0.1, -0.8))
                .box("glow", new Vec3(0, 4000, -25_000), new Vec3(40_000, 3_000, 10_000))
                .portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), 4, 4)
                .portal("b", "a", new Vec3(0, 4000, 0), new Vec3(0, 0, -1), 4, 4)
                .level();
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            float[] through = offscreen.radiance(level, TestAssets.NONE, view(new Vec3(0, 0, 1), Vec3.ZERO));
            float[] moved =
                    offscreen.radiance(level, TestAssets.NONE, view(new Vec3(0, 4000, 1), new Vec3(0, 4000, 0)));
            for (int c = 0; c < 3; c++) {
                assertEquals(1, through[MIDDLE + c] / moved[MIDDLE + c], 1e-3);
                assertNotEquals(1, moved[MIDDLE + c] / number(GLOW, c), 0.05, "20 km of air are seen");
            }
        }
    }

    /** Black walls in a night of full moon, towards the moon's side and away from it. */
    @ParameterizedTest
    @ValueSource(doubles = {4_000, 40_000})
    void atNightTheAirIsMoonlit(double metres) {
        Vec3 sun = new Vec3(0, Math.sin(Math.toRadians(-30)), Math.cos(Math.toRadians(-30)));
        var night = new Sky.Atmosphere(0.3, 1, 0.8, 1, 40, 20, 23, 0, 0.267);
        for (double side : new double[] {-1, 1}) {
            Level wall = glowing(sun)
                    .sky(night)
                    .material(new Material("black", Vec3.ZERO, null, null, null, null, Vec3.ZERO, 1))
                    .box("black", new Vec3(0, 0, side * 1.5 * metres), new Vec3(3 * metres, 3 * metres, metres))
                    .level();
            AirOfEnvironment exact = AirOfEnvironment.of(wall.environment()).orElseThrow();
            try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
                Vec3 eye = new Vec3(0, 2, 0);
                float[] seen = offscreen.radiance(wall, TestAssets.NONE, view(eye, new Vec3(0, 2, side)));
                Vec3 there = new Vec3(0, 2, side * metres);
                Vector3d wanted = exact.over(new Vector3d(), there, new Vector3d(0, 0, side), metres);
                for (int c = 0; c < 3; c++) {
                    assertEquals(1, seen[MIDDLE + c] / wanted.get(c), 0.06, "side " + side);
                }
            }
        }
    }

    private static double number(Vec3 v, int index) {
        return index == 0 ? v.x() : index == 1 ? v.y() : v.z();
    }
}
