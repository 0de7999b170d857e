package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Body;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The reference path tracer shows bodies with the right shapes and shadows, also inside portals. */
@Execution(ExecutionMode.CONCURRENT)
class VisibleBodyTest {
    private static final TraceSettings SETTINGS = new TraceSettings(80, 60, 1, 1, 1);
    private static final Vec3 TOWARDS_EYE = new Vec3(0, 0, 1);

    private static TestLevel stage() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.1, 0.2, 0.9), TestLevel.grey(0.7), new Vec3(0.3, 0.2, 0)))
                .ambient(1)
                .material("wall", TestLevel.grey(0.8))
                .material("red", new Vec3(0.9, 0.1, 0))
                .material("green", new Vec3(0, 0.5, 0.1));
    }

    /** Bodies cover the expected area of a distant picture: a box's front, a disc, a stadium. */
    @Test
    void shapesCoverWhatTheyShould() {
        Pinhole eye = Traced.eye(new Vec3(0, 0, 200), Vec3.ZERO, 0.005);
        TraceSettings fine = new TraceSettings(400, 400, 1, 1, 1);
        double pixel = 2.0 * 2.0 / (400 * 400);
        Body[] bodies = {
            new Body.Box("b", Vec3.ZERO, new Vec3(0.8, 0.6, 1e-3), 1, "red", 0, 0),
            new Body.Sphere("b", Vec3.ZERO, 0.5, 1, "red", 0, 0),
            new Body.Capsule("b", Vec3.ZERO, 0.3, 1.4, 1, "red", 0, 0)
        };
        double[] areas = {0.48, Math.PI * 0.25, Math.PI * 0.09 + 0.6 * 0.8};
        for (int i = 0; i < bodies.length; i++) {
            float[] seen = Traced.picture(stage().body(bodies[i]), eye, fine);
            int covered = 0;
            for (int at = 0; at < seen.length; at += 3) {
                covered += Math.abs(seen[at] - 0.9f) < 1e-6 ? 1 : 0;
            }
            assertEquals(areas[i], covered * pixel, 0.005, bodies[i].toString());
        }
    }

    /** A box body looks like a box solid in the light of sun and sky. */
    @Test
    void aBoxIsABox() {
        Vec3 centre = new Vec3(0.3, 0.4, -0.2);
        Vec3 size = new Vec3(0.7, 0.8, 0.9);
        Pinhole eye = Traced.eye(new Vec3(2, 2, 3), new Vec3(0, 0.3, 0), 0.6);
        TraceSettings several = new TraceSettings(60, 50, 8, 1, 1);
        float[] body = Traced.picture(floor().body(new Body.Box("b", centre, size, 1, "red", 0, 0)), eye, several);
        float[] solid = Traced.picture(floor().box("red", centre, size), eye, several);
        assertArrayEquals(solid, body, 1e-5f);
    }

    private static TestLevel floor() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Constant(TestLevel.grey(0.5)))
                .castingSun(new Vec3(-0.4, 1, 0.3), 2)
                .material("wall", TestLevel.grey(0.8))
                .material("red", new Vec3(0.9, 0.1, 0))
                .box("wall", new Vec3(0, -0.5, 0), new Vec3(20, 1, 20));
    }

    /** The shadow of a ball under a light at a height of 3 m ends where the tangent reaches the ground. */
    @Test
    void aBallShadesADisc() {
        TestLevel ball = new TestLevel()
                .ambient(0.1)
                .material("wall", TestLevel.grey(0.8))
                .light(new Light.Point("l", new Vec3(0, 3, 0), TestLevel.grey(20), 50, true))
                .box("wall", new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                .body(new Body.Sphere("b", new Vec3(0, 1, 0), 0.4, 1, null, 0, 0));
        double edge = 3 * 0.4 / Math.sqrt(2 * 2 - 0.4 * 0.4);
        for (double off : new double[] {-0.01, 0.01}) {
            float seen = Traced.towards(ball, new Vec3(4, 2, 0.3), new Vec3(edge + off, 0, 0), 1)[0];
            assertEquals(off > 0, seen > 0.09, "at " + off);
        }
    }

    /** Returns objects and bodies around a doorway seen along −z; the eye is in front of it. */
    private static TestLevel doorway(Body... bodies) {
        double thin = 1e-4;
        TestLevel stage = stage().box("wall", new Vec3(-3.5, 0, -thin / 2), new Vec3(6, 6, thin))
                .box("wall", new Vec3(3.5, 0, -thin / 2), new Vec3(6, 6, thin))
                .box("wall", new Vec3(0, 2, -thin / 2), new Vec3(1, 2, thin))
                .box("wall", new Vec3(0, -2, -thin / 2), new Vec3(1, 2, thin))
                .box("green", new Vec3(-0.9, 0, -4), new Vec3(1, 3, 0.4));
        for (Body body : bodies) {
            stage.body(body);
        }
        return stage;
    }

    /** Returns the same with a pair of portals: the objects behind the doorway are at x = 100, rotated by 90°. */
    private static TestLevel pair(Body... bodies) {
        TestLevel stage = stage().box("wall", new Vec3(0, 0, -5), new Vec3(13, 6, 10))
                .box("green", new Vec3(104, 0, -0.9), new Vec3(0.4, 3, 1))
                .box("wall", new Vec3(99, 0, 0), new Vec3(2, 6, 6))
                .portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 1, 2)
                .portal("b", "a", new Vec3(100, 0, 0), new Vec3(1, 0, 0), 1, 2);
        for (Body body : bodies) {
            stage.body(body);
        }
        return stage;
    }

    /** A body halfway through a portal is visible on both sides as in an open doorway. */
    @Test
    void whoStandsInAPortalIsSeenOnBothSides() {
        Vec3 here = new Vec3(0.1, -0.2, 0.15);
        Body[] bodies = {
            new Body.Box("b", here, new Vec3(0.6, 0.7, 0.8), 1, "red", 0, 0),
            new Body.Sphere("b", here, 0.35, 1, "red", 0, 0),
            new Body.Capsule("b", here, 0.3, 1.2, 1, "red", 0, 0)
        };
        for (Body body : bodies) {
            for (Vec3 from : new Vec3[] {new Vec3(0.2, 0.1, 3), new Vec3(-1.2, 0.4, 0.7)}) {
                Pinhole eye = Traced.eye(from, new Vec3(0, 0, -1), 0.7);
                int differing = differing(
                        Traced.picture(doorway(body), eye, SETTINGS), Traced.picture(pair(body), eye, SETTINGS));
                assertTrue(differing <= 1, differing + " pixels differ of " + body);
            }
        }
    }

    /** Only the image is visible from the far side, cut by the exit's plane. */
    @Test
    void theImageIsSeenFromTheFarSide() {
        Body body = new Body.Sphere("b", new Vec3(0, 0, 0.1), 0.4, 1, "red", 0, 0);
        Body turned = new Body.Sphere("b", new Vec3(99.9, 0, 0), 0.4, 1, "red", 0, 0);
        Pinhole eye = Traced.eye(new Vec3(103, 0.5, 2), new Vec3(100, 0, 0), 0.4);
        float[] seen = Traced.picture(pair(body), eye, SETTINGS);
        float[] expected = Traced.picture(
                stage().box("green", new Vec3(104, 0, -0.9), new Vec3(0.4, 3, 1))
                        .box("wall", new Vec3(99, 0, 0), new Vec3(2, 6, 6))
                        .body(turned),
                eye,
                SETTINGS);
        int red = 0;
        for (int i = 0; i < seen.length; i += 3) {
            boolean isBody = Math.abs(expected[i] - 0.9f) < 1e-6;
            red += isBody ? 1 : 0;
            assertTrue(!isBody || Math.abs(seen[i] - 0.9f) < 1e-6, "pixel " + i / 3);
        }
        assertTrue(red > 100, red + " pixels");
    }

    /** The part of a body that is through a hanging portal is not visible behind it, nor the rest at the exit. */
    @Test
    void bodiesAreCutByThePlanesOfPortals() {
        TestLevel hanging = stage().portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 1, 2)
                .portal("b", "a", new Vec3(100, 0, 0), TOWARDS_EYE, 1, 2)
                .body(new Body.Sphere("b", new Vec3(0, 0, 0.1), 0.4, 1, "red", 0, 0));
        assertEquals(0.9, Traced.towards(hanging, new Vec3(0, 0, 3), Vec3.ZERO, 1)[0], 1e-6);
        assertEquals(0.9, Traced.towards(hanging, new Vec3(100, 0, 3), new Vec3(100, 0, 0), 1)[0], 1e-6);
        for (double x : new double[] {0, 100}) {
            float[] behind = Traced.towards(hanging, new Vec3(x, 0, -3), new Vec3(x, 0, 0), 1);
            assertEquals(0.7, behind[0], 1e-6, "the sky, at " + x);
        }
    }

    private static int differing(float[] first, float[] second) {
        int pixels = 0;
        for (int i = 0; i < first.length; i += 3) {
            float off = Math.abs(first[i] - second[i]) + Math.abs(first[i + 1] - second[i + 1]);
            pixels += off + Math.abs(first[i + 2] - second[i + 2]) > 1e-6 ? 1 : 0;
        }
        return pixels;
    }
}
