package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
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
    private static final Vec3 EYE = new Vec3(0, 2, 0);
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 GLOW = new Vec3(20, 10, 5);
    private static final AirTables CLEAR = AirTables.of(Air.CLEAR);

    private static TestLevel glowing(Vec3 towardsSun) {
        return new TestLevel()
                .sky(Sky.Atmosphere.CLEAR)
                .sun(towardsSun, IRRADIANCE)
                .material(new Material("glow", Vec3.ZERO, null, null, null, null, GLOW, 1));
    }

    private static View view(Vec3 eye, Vec3 target) {
        return View.lookAt(eye, target, UP, new Projection(Math.PI / 2, 1, 0.05, 2e5));
    }

    /** A distance and the direction, one of four, in which a wall that fills the picture is as far away. */
    private record Wall(double metres, Vec3 towards) {
        private static final List<Wall> ALL = List.of(
                new Wall(5, new Vec3(0, 0, -1)),
                new Wall(700, new Vec3(0, 0, 1)),
                new Wall(9_000, new Vec3(-1, 0, 0)),
                new Wall(60_000, new Vec3(1, 0, 0)));

        /** Builds a wall that leaves the walls beside it in sight. */
        TestLevel addTo(TestLevel level, String material) {
            Vec3 across = new Vec3(Math.abs(towards.z()), 0, Math.abs(towards.x()));
            Vec3 along = new Vec3(Math.abs(towards.x()), 0, Math.abs(towards.z()));
            Vec3 size = across.scaled(2 * metres).addScaled(metres, along).plus(new Vec3(0, 3 * metres, 0));
            return level.box(material, towards.scaled(1.5 * metres), size);
        }

        /** Returns the way from the eye to what a pixel shows. */
        Vec3 pathTo(int pixel) {
            double x = (2 * (pixel % SIDE) + 1.0) / SIDE - 1;
            double y = (2 * (pixel / SIDE) + 1.0) / SIDE - 1;
            return towards.addScaled(x, towards.cross(UP)).addScaled(y, UP).scaled(metres);
        }

        View view() {
            return AerialPerspectiveGlTest.view(EYE, EYE.plus(towards));
        }
    }

    /** The upper half of each picture is above the horizon. */
    @ParameterizedTest
    @ValueSource(doubles = {50, 1, -3})
    void theShaderIsTheTableAtEveryPixel(double sunDegrees) {
        double elevation = Math.toRadians(sunDegrees);
        Vec3 sun = new Vec3(0.6 * Math.cos(elevation), Math.sin(elevation), -0.8 * Math.cos(elevation));
        AerialTable table = new AerialTable(CLEAR, EYE.y(), sun.y());
        TestLevel level = glowing(sun);
        Wall.ALL.forEach(wall -> wall.addTo(level, "glow"));
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            List<float[]> pictures = offscreen.radiance(
                    level.level(),
                    TestAssets.NONE,
                    Wall.ALL.stream().map(Wall::view).toList());
            for (int n = 0; n < pictures.size(); n++) {
                Wall wall = Wall.ALL.get(n);
                for (int i = 0; i < SIDE * SIDE; i++) {
                    Vec3 path = wall.pathTo(i);
                    AirLight air = table.along(path.scaled(1 / path.length()), sun, path.length());
                    assertSeen(air, pictures.get(n), 3 * i, "" + path);
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

    /** Black walls in a night of full moon, around the eye: every pixel is what the integration gives. */
    @Test
    void atNightTheAirIsMoonlit() {
        Vec3 sun = new Vec3(0, Math.sin(Math.toRadians(-30)), Math.cos(Math.toRadians(-30)));
        TestLevel level = new TestLevel()
                .sky(new Sky.Atmosphere(0.3, 1, 0.8, 1, 40, 20, 23, 0, 0.267))
                .sun(sun, IRRADIANCE)
                .material(new Material("black", Vec3.ZERO, null, null, null, null, Vec3.ZERO, 1));
        List<Wall> walls = Wall.ALL.subList(1, 4);
        walls.forEach(wall -> wall.addTo(level, "black"));
        AirOfEnvironment exact =
                AirOfEnvironment.of(level.level().environment()).orElseThrow();
        try (Offscreen offscreen = new Offscreen(SIDE, SIDE)) {
            List<float[]> pictures = offscreen.radiance(
                    level.level(),
                    TestAssets.NONE,
                    walls.stream().map(Wall::view).toList());
            for (int n = 0; n < walls.size(); n++) {
                for (int i = 0; i < SIDE * SIDE; i++) {
                    Vec3 path = walls.get(n).pathTo(i);
                    Vec3 away = path.scaled(1 / path.length());
                    Vector3d wanted = exact.over(new Vector3d(), EYE.plus(path), away.toVector(), path.length());
                    for (int c = 0; c < 3; c++) {
                        assertEquals(1, pictures.get(n)[3 * i + c] / wanted.get(c), 0.06, "" + path);
                    }
                }
            }
        }
    }

    private static double number(Vec3 v, int index) {
        return index == 0 ? v.x() : index == 1 ? v.y() : v.z();
    }
}
