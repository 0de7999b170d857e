package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.junit.jupiter.api.Test;

/** Portals show the picture that an opening to the space behind them would show. */
class VisiblePortalTest {
    private static final TraceSettings SETTINGS = new TraceSettings(96, 64, 1, 1, 1);
    private static final Sky SKY =
            new Sky.Gradient(new Vec3(0.1, 0.2, 0.9), TestLevel.grey(0.7), new Vec3(0.3, 0.2, 0));
    private static final Vec3 TOWARDS_EYE = new Vec3(0, 0, 1);

    private static TestLevel stage() {
        return new TestLevel()
                .skyLight()
                .sky(SKY)
                .ambient(1)
                .material("wall", TestLevel.grey(0.8))
                .material("red", new Vec3(0.9, 0.1, 0))
                .material("green", new Vec3(0, 0.5, 0.1));
    }

    /** Adds objects behind a doorway with its centre at the origin, seen along −z. */
    private static TestLevel furnished(TestLevel stage) {
        return stage.box("red", new Vec3(0.2, -0.6, -2), new Vec3(0.5, 0.8, 0.6))
                .box("green", new Vec3(-0.9, 0, -4), new Vec3(1, 3, 0.4));
    }

    /** Adds the same objects behind a portal at (x, 0, 0) that faces +x: rotated by a quarter turn to the left. */
    private static TestLevel turnedDynamicObjects(TestLevel stage, double x) {
        return stage.box("red", new Vec3(x + 2, -0.6, 0.2), new Vec3(0.6, 0.8, 0.5))
                .box("green", new Vec3(x + 4, 0, -0.9), new Vec3(0.4, 3, 1));
    }

    /** Returns a thin wall with a hole of 1 m × 2 m. */
    private static TestLevel doorway() {
        double thin = 1e-4;
        return furnished(stage())
                .box("wall", new Vec3(-3.5, 0, -thin / 2), new Vec3(6, 6, thin))
                .box("wall", new Vec3(3.5, 0, -thin / 2), new Vec3(6, 6, thin))
                .box("wall", new Vec3(0, 2, -thin / 2), new Vec3(1, 2, thin))
                .box("wall", new Vec3(0, -2, -thin / 2), new Vec3(1, 2, thin));
    }

    private static TestLevel wall() {
        return stage().box("wall", new Vec3(0, 0, -5), new Vec3(13, 6, 10));
    }

    @Test
    void aPairShowsWhatAnOpenDoorwayShows() {
        TestLevel pair = turnedDynamicObjects(wall(), 100)
                .box("wall", new Vec3(99, 0, 0), new Vec3(2, 6, 6))
                .portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 1, 2)
                .portal("b", "a", new Vec3(100, 0, 0), new Vec3(1, 0, 0), 1, 2);
        for (Vec3 from : new Vec3[] {new Vec3(0.2, 0.1, 3), new Vec3(-1.5, 0.4, 2), new Vec3(0, 0, 0.01)}) {
            Pinhole eye = Traced.eye(from, new Vec3(from.x() / 2, 0, -1), 0.8);
            int differing = differing(Traced.picture(doorway(), eye, SETTINGS), Traced.picture(pair, eye, SETTINGS));
            assertTrue(differing <= 1, differing + " pixels differ; one may meet the thin wall's edge");
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

    /** A portal is invisible from behind and without a partner. */
    @Test
    void whatLeadsNowhereShowsTheWall() {
        TestLevel bare = furnished(wall());
        Pinhole eye = Traced.eye(new Vec3(0.2, 0.1, 3), Vec3.ZERO, 0.8);
        float[] expected = Traced.picture(bare, eye, SETTINGS);
        TestLevel behind = furnished(wall())
                .portal("a", "b", new Vec3(0, 0, 1), new Vec3(0, 0, -1), 1, 2)
                .portal("b", "a", new Vec3(50, 0, 0), TOWARDS_EYE, 1, 2);
        assertArrayEquals(expected, Traced.picture(behind, eye, SETTINGS));
        TestLevel single = furnished(wall()).portal("a", "nobody", Vec3.ZERO, TOWARDS_EYE, 1, 2);
        assertArrayEquals(expected, Traced.picture(single, eye, SETTINGS));
    }

    /** Near and far planes apply to the whole path: 3 m to the portal and 2 m to the object behind it. */
    @Test
    void depthGoesOnBehindAPortal() {
        TestLevel pair = wall().box("red", new Vec3(100, 0, -3), new Vec3(2, 2, 2))
                .portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 1, 2)
                .portal("b", "a", new Vec3(100, 0, 0), new Vec3(0, 0, -1), 1, 2);
        Pinhole eye = Traced.eye(new Vec3(0, 0, 3), Vec3.ZERO, 1e-6);
        TraceSettings one = new TraceSettings(1, 1, 1, 1, 1);
        for (double limit : new double[] {4.99, 5.01}) {
            Pinhole near = new Pinhole(eye.eye(), eye.basis(), 1e-6, 1e-6, limit, 1e4);
            Pinhole far = new Pinhole(eye.eye(), eye.basis(), 1e-6, 1e-6, 0.05, limit);
            assertEquals(limit < 5 ? 0.9 : 0.7, Traced.picture(pair, near, one)[0], 1e-6);
            assertEquals(limit < 5 ? 0.7 : 0.9, Traced.picture(pair, far, one)[0], 1e-6);
        }
    }

    /** Two portals 3 m apart face each other: a ray that climbs 1 mm per metre leaves them after 333 crossings. */
    @Test
    void facingPortalsRepeatAsOftenAsARayMeetsThem() {
        TestLevel facing = stage().box("red", new Vec3(0, 0, -1.6), new Vec3(4, 8, 0.2))
                .box("green", new Vec3(0, 0, 1.6), new Vec3(4, 8, 0.2))
                .portal("a", "b", new Vec3(0, 0, -1.5), TOWARDS_EYE, 1, 2)
                .portal("b", "a", new Vec3(0, 0, 1.5), new Vec3(0, 0, -1), 1, 2);
        Vec3 middle = Vec3.ZERO;
        float[] wall = Traced.towards(facing, middle, new Vec3(0, 1e-3, -1), 1);
        assertEquals(0.9, wall[0], 1e-6);
        EyePath path = new EyePath(
                new TracedItems(StaticShapes.of(facing.level()), List.of(), 0, List.of(), List.of()),
                Portals.of(facing.level()),
                FaceMaterials.NONE);
        assertTrue(path.trace(middle.toVector(), new Vec3(0, 1e-3, -1).toVector(), 0.05, 1e9));
        assertEquals(1, path.ray().originY(), 3.1e-3, "in the last space, under the upper edge");
        float[] along = Traced.towards(facing, middle, new Vec3(0, 0, -1), 1);
        assertEquals(0.7, along[0], 1e-6, "never black: the sky stands for what is smaller than any pixel");
    }

    /** Eye rays pass through portals, the light of a punctual light or the sun does not. */
    @Test
    void lightDoesNotPassPortals() {
        Light light = new Light.Point("l", new Vec3(0, 0, 1), TestLevel.grey(50), 20, true);
        TestLevel dark = new TestLevel()
                .ambient(0)
                .material("m", TestLevel.grey(1))
                .light(light)
                .box("m", new Vec3(0, 0, -5), new Vec3(13, 6, 10))
                .box("m", new Vec3(100, 0, -5), new Vec3(13, 6, 0.5))
                .portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 1, 2)
                .portal("b", "a", new Vec3(100, 0, 0), new Vec3(0, 0, -1), 1, 2);
        assertEquals(0, Traced.towards(dark, new Vec3(0, 0, 2), new Vec3(0, 0, 0), 1)[0]);
        assertTrue(Traced.towards(dark, new Vec3(0, 0, 2), new Vec3(0.8, 0, 0), 1)[0] > 0);
    }
}
