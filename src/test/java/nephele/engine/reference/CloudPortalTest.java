package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.tile.TiledPicture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Eye paths see clouds through portals and mirrors; scattered light, sun and sky meet portals and surfaces as walls. */
@Execution(ExecutionMode.CONCURRENT)
class CloudPortalTest {
    private static final Vec3 TOWARDS_EYE = new Vec3(0, 0, 1);

    /** 12 m behind the exit at x = 100, which looks along −z as the entry does. */
    private static final Vec3 CLOUD = new Vec3(100, 0, -14);

    private static TestLevel sky() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.1, 0.3, 0.9), TestLevel.grey(0.6), new Vec3(0.2, 0.1, 0)))
                .castingSun(new Vec3(1, 2, -0.5), 3)
                .material("red", new Vec3(0.9, 0, 0));
    }

    /** Walls 2 m thick stand behind both portals; through the far one an eye inside it sees the same as through the pair. */
    private static TestLevel pair() {
        return sky().box("red", new Vec3(0, 0, -1), new Vec3(13, 8, 2))
                .box("red", new Vec3(100, 0, 1), new Vec3(13, 8, 2))
                .portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 2, 2)
                .portal("b", "a", new Vec3(100, 0, 0), TOWARDS_EYE.negated(), 2, 2);
    }

    private static TiledPicture picture(TestLevel level, Pinhole eye, int samples, long seed) {
        TracedLevel traced = TracedLevel.of(PlacedLevel.of(level.level(), TestAssets.NONE), ColourDecoding.SRGB);
        return ReferencePicture.picture(traced, eye, new TraceSettings(12, 12, samples, seed, 1), done -> {});
    }

    private static void assertSame(TiledPicture a, TiledPicture b, double tint) {
        float[] errorA = a.standardError();
        float[] errorB = b.standardError();
        double greatest = 0;
        double least = 9;
        for (int i = 0; i < a.rgb().length; i++) {
            double sigma = Math.hypot(tint * errorA[i], errorB[i]);
            assertEquals(tint * a.rgb()[i], b.rgb()[i], 4 * sigma + 1e-6, "value " + i);
            greatest = Math.max(greatest, a.rgb()[i]);
            least = Math.min(least, a.rgb()[i]);
        }
        assertTrue(greatest > 1.5 * least, "something is seen: " + least + " to " + greatest);
    }

    @Test
    void aCloudThroughAPairOfPortalsIsSeenAsByTheEyeBehindIt() {
        TestLevel level = pair().cloud(CLOUD, new Vec3(12, 9, 10), 0.5, 0.9, 0.6);
        Pinhole before = Traced.eye(new Vec3(0, 0, 1.5), Vec3.ZERO, 0.6);
        Pinhole behind = Traced.eye(new Vec3(100, 0, 1.5), new Vec3(100, 0, 0), 0.6);
        assertSame(picture(level, before, 128, 1), picture(level, behind, 128, 2), 1);
    }

    /** The cloud fills both portals and all between them: the eye meets it before the entry and behind the exit. */
    @Test
    void aCloudAroundAPortalHasThePortalAsAWall() {
        TestLevel open = sky().portal("a", "b", Vec3.ZERO, TOWARDS_EYE, 6, 6)
                .portal("b", "a", new Vec3(100, 0, 0), TOWARDS_EYE.negated(), 6, 6)
                .cloud(Vec3.ZERO, new Vec3(10, 10, 10), 0.3, 1, 0);
        TestLevel walled = sky().box("red", new Vec3(0, 0, -1e-4), new Vec3(6, 6, 2e-4))
                .cloud(Vec3.ZERO, new Vec3(10, 10, 10), 0.3, 1, 0);
        TestLevel without = sky().cloud(Vec3.ZERO, new Vec3(10, 10, 10), 0.3, 1, 0);
        // The ray passes before the portal, in parallel to it, and crosses neither.
        Pinhole along = Traced.eye(new Vec3(0, 9, 0.4), new Vec3(0, 0, 0.4), 1e-3);
        Mean closed = Mean.of(picture(walled, along, 256, 1));
        Mean portal = Mean.of(picture(open, along, 256, 2));
        Mean none = Mean.of(picture(without, along, 256, 3));
        assertEquals(closed.value, portal.value, 4 * Math.hypot(closed.error, portal.error));
        assertTrue(none.value > 1.2 * closed.value, none + " and " + closed);
    }

    private record Mean(double value, double error) {
        static Mean of(TiledPicture picture) {
            double sum = 0;
            double variance = 0;
            float[] error = picture.standardError();
            for (int i = 0; i < error.length; i += 3) {
                sum += picture.rgb()[i];
                variance += error[i] * error[i];
            }
            return new Mean(3 * sum / error.length, 3 * Math.sqrt(variance) / error.length);
        }
    }

    @Test
    void aCloudInAMirrorIsTheCloudTimesTheMirrorsTint() {
        double tint = 0.5;
        TestLevel level = sky().material(new nephele.engine.level.Material(
                        "mirror", TestLevel.grey(tint), null, null, null, null, Vec3.ZERO, 1, true))
                .box("mirror", new Vec3(0, 0, -5), new Vec3(40, 40, 10))
                .cloud(new Vec3(0, 3, 14), new Vec3(12, 9, 10), 0.5, 0.9, 0.6);
        Pinhole intoMirror = Traced.eye(new Vec3(0, 0.5, 3), new Vec3(0, 0.5, 0), 0.3);
        var basis = new nephele.engine.math.Basis(
                intoMirror.basis().right(),
                intoMirror.basis().up(),
                intoMirror.basis().back().negated());
        // The mirrored eye looks out of the mirror's solid, whose faces are invisible from inside.
        Pinhole fromMirror = new Pinhole(new Vec3(0, 0.5, -3), basis, 0.3, 0.3, 0.05, 1e4);
        assertSame(picture(level, fromMirror, 128, 1), picture(level, intoMirror, 128, 2), tint);
    }

    /** A cloud in a closed room is dark, however bright the sky; a hole lets light in. */
    @Test
    void surfacesKeepSunAndSkyFromClouds() {
        TestLevel room = sky().box("red", new Vec3(0, 6, 0), new Vec3(14, 1, 14))
                .box("red", new Vec3(0, -6, 0), new Vec3(14, 1, 14))
                .box("red", new Vec3(6, 0, 0), new Vec3(1, 14, 14))
                .box("red", new Vec3(-6, 0, 0), new Vec3(1, 14, 14))
                .box("red", new Vec3(0, 0, -6), new Vec3(14, 14, 1))
                .cloud(Vec3.ZERO, new Vec3(9, 9, 9), 3, 1, 0.5);
        Pinhole eye = Traced.eye(new Vec3(0, 0, 5.4), Vec3.ZERO, 0.3);
        assertTrue(Mean.of(picture(room, eye, 32, 1)).value > 1e-3, "one side is open");
        room.box("red", new Vec3(0, 0, 6), new Vec3(14, 14, 1));
        assertEquals(0, Mean.of(picture(room, eye, 32, 1)).value, 1e-9);
    }

    /** An opaque black cloud between eye and wall hides it, under fog that stands before the cloud. */
    @Test
    void fogStandsBeforeClouds() {
        TestLevel level = sky().fog(0.1, new Vec3(0.5, 0.5, 0.5))
                .box("red", new Vec3(0, 0, -20), new Vec3(30, 30, 1))
                .layer(-3, 2, 1e3, 0, 0);
        Pinhole down = Traced.eye(new Vec3(0, 4, 0.001), Vec3.ZERO, 1e-4);
        assertEquals(0.5 * (1 - Math.exp(-0.1 * 5)), picture(level, down, 8, 1).rgb()[0], 1e-3);
    }
}
