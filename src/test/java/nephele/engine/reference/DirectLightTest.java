package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Light;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The light of sun and punctual lights matches values calculated by hand. */
class DirectLightTest {
    private static final Vec3 EYE = new Vec3(0.3, 4, 5);

    private static TestLevel floor(double albedo) {
        return new TestLevel()
                .ambient(0)
                .material("m", TestLevel.grey(albedo))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40));
    }

    @Test
    void aLambertPlaneUnderTheSunSendsAlbedoOverPiTimesIrradianceTimesCosine() {
        float[] seen = Traced.towards(floor(0.6).castingSun(new Vec3(3, 4, 0), 2), EYE, Vec3.ZERO, 1);
        assertEquals(0.6 / Math.PI * 2 * 0.8, seen[0], 1e-7);
    }

    @Test
    void aLightThinsOutWithTheSquareOfTheDistanceUnderItsWindow() {
        Light light = new Light.Point("l", new Vec3(0, 2, 0), TestLevel.grey(10), 5, true);
        double window = Math.pow(1 - Math.pow(2.0 / 5, 4), 2);
        assertEquals(
                0.5 / Math.PI * 10 / 4 * window, Traced.towards(floor(0.5).light(light), EYE, Vec3.ZERO, 1)[0], 1e-6);
        Vec3 beyondRange = new Vec3(4.7, 0, 0);
        assertEquals(0, Traced.towards(floor(0.5).light(light), EYE, beyondRange, 1)[0]);
    }

    /** With an outer cone of 45° at a height of 2 m light reaches 2 m from the point below it. */
    @Test
    void aSpotEndsAtItsOuterCone() {
        Light spot = new Light.Spot("s", new Vec3(0, 2, 0), new Vec3(0, -3, 0), TestLevel.grey(10), 100, 30, 45, true);
        float within = Traced.towards(floor(1).light(spot), EYE, new Vec3(1.1, 0, 0), 1)[0];
        double cube = Math.pow(4 + 1.21, 1.5);
        assertEquals(10 * 2 / cube / Math.PI, within, 1e-4);
        assertEquals(0, Traced.towards(floor(1).light(spot), EYE, new Vec3(2.001, 0, 0), 1)[0]);
    }

    /** The intensity between the cones is the square of a ramp over the cosine; both cones are exact. */
    @Test
    void aSpotsRimIsASquaredRampOverTheCosine() {
        Light spot = new Light.Spot("s", new Vec3(0, 2, 0), new Vec3(0, -1, 0), TestLevel.grey(10), 1e6, 30, 45, true);
        TestLevel lit = floor(1).light(spot);
        double inner = Math.cos(Math.toRadians(30));
        double outer = Math.cos(Math.toRadians(45));
        for (double degrees : new double[] {0, 29.9, 30.1, 33, 36, 39, 42, 44, 44.9}) {
            double cosine = Math.cos(Math.toRadians(degrees));
            double ramp = Math.min(1, (cosine - outer) / (inner - outer));
            double expected = 10 * Math.pow(cosine, 3) / 4 * ramp * ramp / Math.PI;
            Vec3 on = new Vec3(2 * Math.tan(Math.toRadians(degrees)), 0, 0);
            float seen = Traced.towards(lit, EYE, on, 1)[0];
            assertEquals(expected, seen, 1e-6 * expected + 1e-9, degrees + " degrees off the axis");
        }
    }

    /** Both shadows of a wall of 1 m, of a sun at 45° and a light at (0, 3, −2), end at the ray over the edge. */
    @Test
    void shadowsEndWhereTheRayOverTheEdgeLands() {
        TestLevel sunny =
                floor(0.5).box("m", new Vec3(0, 0.5, -0.5), new Vec3(4, 1, 1)).castingSun(new Vec3(0, 1, -1), 1);
        assertEdge(sunny, 1);
        Light light = new Light.Point("l", new Vec3(0, 3, -2), TestLevel.grey(10), 50, true);
        TestLevel lit =
                floor(0.5).box("m", new Vec3(0, 0.5, -0.5), new Vec3(4, 1, 1)).light(light);
        assertEdge(lit, 1);
    }

    private static void assertEdge(TestLevel stage, double z) {
        assertEquals(0, Traced.towards(stage, EYE, new Vec3(0, 0, z - 1e-5), 1)[0]);
        float lit = Traced.towards(stage, EYE, new Vec3(0, 0, z + 1e-5), 1)[0];
        assertEquals(Traced.towards(stage, EYE, new Vec3(0, 0, z + 2e-5), 1)[0], lit, 1e-4);
        assertEquals(1, Math.signum(lit));
    }

    /** Neither the joint of two floors nor the foot of a wall is lit or dark by rounding. */
    @Test
    void jointsNeitherLeakNorStain() {
        TestLevel tiles =
                new TestLevel().ambient(0).material("m", TestLevel.grey(1)).castingSun(new Vec3(0.2, 1, 0.1), Math.PI);
        tiles.box("m", new Vec3(-5, -0.5, 0), new Vec3(10, 1, 20)).box("m", new Vec3(5, -0.5, 0), new Vec3(10, 1, 20));
        float open = Traced.towards(tiles, EYE, new Vec3(3, 0, 0), 1)[0];
        for (double x : new double[] {-1e-9, 0, 1e-9}) {
            assertEquals(open, Traced.towards(tiles, EYE, new Vec3(x, 0, 0), 1)[0], 1e-6);
        }
        tiles.box("m", new Vec3(1, 1, 0), new Vec3(2, 2, 4));
        for (double x : new double[] {-1e-9, -1e-6, -1e-3}) {
            assertEquals(0, Traced.towards(tiles, new Vec3(-4, 4, 0), new Vec3(x, 0, 0), 1)[0], "at " + x);
        }
    }
}
