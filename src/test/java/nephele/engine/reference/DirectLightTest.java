package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Light;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Sun and lamps against what is worked out by hand. */
class DirectLightTest {
    private static final Vec3 EYE = new Vec3(0.3, 4, 5);

    private static Stage floor(double albedo) {
        return new Stage()
                .ambient(0)
                .lambert("m", Stage.grey(albedo))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40));
    }

    @Test
    void aLambertPlaneUnderTheSunSendsAlbedoOverPiTimesIrradianceTimesCosine() {
        float[] seen = floor(0.6).sun(new Vec3(3, 4, 0), 2).towards(EYE, Vec3.ZERO, 1);
        assertEquals(0.6 / Math.PI * 2 * 0.8, seen[0], 1e-7);
    }

    @Test
    void aLampThinsOutWithTheSquareOfTheDistanceUnderItsWindow() {
        Light lamp = new Light.Point("l", new Vec3(0, 2, 0), Stage.grey(10), 5, true);
        double window = Math.pow(1 - Math.pow(2.0 / 5, 4), 2);
        assertEquals(0.5 / Math.PI * 10 / 4 * window, floor(0.5).light(lamp).towards(EYE, Vec3.ZERO, 1)[0], 1e-6);
        Vec3 beyondRange = new Vec3(4.7, 0, 0);
        assertEquals(0, floor(0.5).light(lamp).towards(EYE, beyondRange, 1)[0]);
    }

    /** Outer cone 45° at a height of 2 m: light up to 2 m from its foot. */
    @Test
    void aSpotEndsAtItsOuterCone() {
        Light spot = new Light.Spot("s", new Vec3(0, 2, 0), new Vec3(0, -3, 0), Stage.grey(10), 100, 30, 45, true);
        float within = floor(1).light(spot).towards(EYE, new Vec3(1.1, 0, 0), 1)[0];
        double cube = Math.pow(4 + 1.21, 1.5);
        assertEquals(10 * 2 / cube / Math.PI, within, 1e-4);
        assertEquals(0, floor(1).light(spot).towards(EYE, new Vec3(2.001, 0, 0), 1)[0]);
    }

    /** Between the cones light falls as the square of a ramp over the cosine; the cones are those written, to a hair. */
    @Test
    void aSpotsRimIsASquaredRampOverTheCosine() {
        Light spot = new Light.Spot("s", new Vec3(0, 2, 0), new Vec3(0, -1, 0), Stage.grey(10), 1e6, 30, 45, true);
        Stage lit = floor(1).light(spot);
        double inner = Math.cos(Math.toRadians(30));
        double outer = Math.cos(Math.toRadians(45));
        for (double degrees : new double[] {0, 29.9, 30.1, 33, 36, 39, 42, 44, 44.9}) {
            double cosine = Math.cos(Math.toRadians(degrees));
            double ramp = Math.min(1, (cosine - outer) / (inner - outer));
            double expected = 10 * Math.pow(cosine, 3) / 4 * ramp * ramp / Math.PI;
            Vec3 on = new Vec3(2 * Math.tan(Math.toRadians(degrees)), 0, 0);
            float seen = lit.towards(EYE, on, 1)[0];
            assertEquals(expected, seen, 1e-6 * expected + 1e-9, degrees + " degrees off the axis");
        }
    }

    /** A wall of 1 m under a sun at 45°, and a lamp at (0, 3, −2): both shadows end where the ray over the edge lands. */
    @Test
    void shadowsEndWhereTheRayOverTheEdgeLands() {
        Stage sunny =
                floor(0.5).box("m", new Vec3(0, 0.5, -0.5), new Vec3(4, 1, 1)).sun(new Vec3(0, 1, -1), 1);
        assertEdge(sunny, 1);
        Light lamp = new Light.Point("l", new Vec3(0, 3, -2), Stage.grey(10), 50, true);
        Stage lit =
                floor(0.5).box("m", new Vec3(0, 0.5, -0.5), new Vec3(4, 1, 1)).light(lamp);
        assertEdge(lit, 1);
    }

    private static void assertEdge(Stage stage, double z) {
        assertEquals(0, stage.towards(EYE, new Vec3(0, 0, z - 1e-5), 1)[0]);
        float lit = stage.towards(EYE, new Vec3(0, 0, z + 1e-5), 1)[0];
        assertEquals(stage.towards(EYE, new Vec3(0, 0, z + 2e-5), 1)[0], lit, 1e-4);
        assertEquals(1, Math.signum(lit));
    }

    /** Neither the joint of two floors nor the foot of a wall is lit or dark by accident. */
    @Test
    void jointsNeitherLeakNorStain() {
        Stage tiles = new Stage().ambient(0).lambert("m", Stage.grey(1)).sun(new Vec3(0.2, 1, 0.1), Math.PI);
        tiles.box("m", new Vec3(-5, -0.5, 0), new Vec3(10, 1, 20)).box("m", new Vec3(5, -0.5, 0), new Vec3(10, 1, 20));
        float open = tiles.towards(EYE, new Vec3(3, 0, 0), 1)[0];
        for (double x : new double[] {-1e-9, 0, 1e-9}) {
            assertEquals(open, tiles.towards(EYE, new Vec3(x, 0, 0), 1)[0], 1e-6);
        }
        tiles.box("m", new Vec3(1, 1, 0), new Vec3(2, 2, 4));
        for (double x : new double[] {-1e-9, -1e-6, -1e-3}) {
            assertEquals(0, tiles.towards(new Vec3(-4, 4, 0), new Vec3(x, 0, 0), 1)[0], "at " + x);
        }
    }
}
