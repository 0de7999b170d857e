package nephele.engine.render.pass.particle;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Emitter;
import nephele.engine.level.Emitter.Kind;
import nephele.engine.level.Level;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures of particles: the same at any time and place, behind openings as from the moved eye, before surfaces only. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ParticleGlTest {
    private static final int SIZE = 48;
    private static final Vec3 CENTRE = new Vec3(0, 0, -5);
    /** An eye whose coordinates have no exact float a million metres out. */
    private static final Vec3 EYE = new Vec3(0.31, 0.17, 0.03);

    private static final double MONTH_SECONDS = 30 * 86_400;
    private static final Vec3 DUSK = new Vec3(0.2, 0.25, 0.4);

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Emitter emitter(Kind kind) {
        double rate = kind == Kind.EXPLOSION ? 60 : 25;
        return new Emitter("e", kind, CENTRE, new Vec3(3, 3, 3), rate, 5, -20, kind == Kind.EXPLOSION ? 5 : 0, 0.2);
    }

    private static TestLevel level(Emitter... emitters) {
        TestLevel level = new TestLevel().sky(new Sky.Constant(DUSK)).sun(new Vec3(1, 1, 1), 1);
        for (Emitter emitter : emitters) {
            level.emitter(emitter);
        }
        return level;
    }

    private float[] radiance(Level level, View view, double... seconds) {
        try (Renderer renderer =
                LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR))) {
            FrameState state = FrameState.atStart(level);
            for (double now : seconds) {
                state.seconds(now);
                renderer.draw(view, state, offscreen.picture);
            }
            offscreen.gl.requireNoError("particles");
            return renderer.readRadiance();
        }
    }

    private View ahead(Vec3 eye) {
        return offscreen.view(eye, eye.plus(new Vec3(0, 0, -1)));
    }

    /** One code of the displayed picture, at its steepest for dark values, is 0.0003 of linear light. */
    private static void assertSame(float[] expected, float[] actual) {
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], actual[i], 3e-4 + 4e-3 * expected[i], "value " + i);
        }
    }

    private static int differing(float[] a, float[] b) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            count += Math.abs(a[i] - b[i]) > 0.01 ? 1 : 0;
        }
        return count;
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void earlierFramesTimesAndPlacesFarOutDoNotMatter(Kind kind) {
        Emitter emitter = emitter(kind);
        Level level = level(emitter).level();
        float[] fresh = radiance(level, ahead(EYE), 0.4);
        assertTrue(differing(fresh, radiance(level().level(), ahead(EYE), 0)) > 20, "nothing is drawn");
        assertArrayEquals(fresh, radiance(level, ahead(EYE), 3, 0.1, 9, 0.4));
        Level later = level(RecordCopy.with(emitter, "startSeconds", MONTH_SECONDS - 20))
                .level();
        assertSame(fresh, radiance(later, ahead(EYE), MONTH_SECONDS + 0.4));
        Vec3 far = new Vec3(1_048_576, -1_048_576, 524_288);
        Level moved =
                level(RecordCopy.with(emitter, "centre", CENTRE.plus(far))).level();
        assertSame(fresh, radiance(moved, ahead(EYE.plus(far)), 0.4));
    }

    /** In a constant sky of radiance 1, flakes and drops that scatter all light cannot be seen, however thick they are. */
    @ParameterizedTest
    @EnumSource(
            value = Kind.class,
            names = {"SNOW", "RAIN", "SMOKE"})
    void whiteFurnace(Kind kind) {
        double rate = kind == Kind.RAIN ? 400 : 60;
        Emitter dense =
                new Emitter("e", kind, CENTRE, new Vec3(4, 4, 4), rate, 5, -20, 0, kind == Kind.SMOKE ? 2 : 0.8);
        Level level = new TestLevel()
                .sky(new Sky.Constant(new Vec3(1, 1, 1)))
                .skyLight()
                .emitter(dense)
                .level();
        float[] seen = radiance(level, ahead(Vec3.ZERO), 0);
        double least = 1;
        for (float value : seen) {
            assertTrue(value <= 1.004, "adds light: " + value);
            least = Math.min(least, value);
        }
        // Smoke scatters 0.86 of the light.
        double expected = kind == Kind.SMOKE ? 0.86 : 1;
        assertTrue(least >= expected - 0.004, "takes light: " + least);
        assertTrue(kind != Kind.SMOKE || least < 0.95, "is too thin: " + least);
    }

    /** One square of the report is white, and has the picture of a cloud: wider than high, and no disc. */
    @Test
    void theReportsSquaresAreWhiteClouds() {
        Emitter one = new Emitter("e", Kind.QUADS, CENTRE, new Vec3(0.01, 0.01, 0.01), 0.7, 5, -0.2, 0, 3);
        Level level =
                new TestLevel().sky(new Sky.Constant(Vec3.ZERO)).emitter(one).level();
        float[] seen = radiance(level, ahead(Vec3.ZERO), 0.9);
        boolean[] columns = new boolean[SIZE];
        boolean[] rows = new boolean[SIZE];
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            assertEquals(seen[3 * pixel], seen[3 * pixel + 2], 1e-3 + 1e-3 * seen[3 * pixel]);
            columns[pixel % SIZE] |= seen[3 * pixel] > 0.05;
            rows[pixel / SIZE] |= seen[3 * pixel] > 0.05;
        }
        assertTrue(count(columns) > 1.2 * count(rows), count(columns) + " columns of " + count(rows) + " rows");
        assertTrue(count(rows) > 5, count(rows) + " rows");
    }

    private static int count(boolean[] any) {
        int count = 0;
        for (boolean each : any) {
            count += each ? 1 : 0;
        }
        return count;
    }

    @Test
    void throughAPortalItIsThePictureOfTheMovedEye() {
        Vec3 away = new Vec3(100, 0, 0);
        for (Kind kind : Kind.values()) {
            Emitter beyond = new Emitter("e", kind, away.plus(CENTRE), new Vec3(2, 2, 1), 60, 5, -20.3, 5, 0.2);
            Emitter before =
                    new Emitter("f", kind, away.plus(new Vec3(0, 0, -1.5)), new Vec3(1, 1, 1), 60, 5, -20.3, 5, 0.1);
            boolean spreads = kind == Kind.EXPLOSION || kind == Kind.SPARKS || kind == Kind.QUADS;
            TestLevel portals = (spreads ? level(beyond) : level(beyond, before))
                    .portal("a", "b", new Vec3(0, 0, -3), new Vec3(0, 0, 1), 4, 4)
                    .portal("b", "a", away.plus(new Vec3(0, 0, -3)), new Vec3(0, 0, -1), 4, 4);
            float[] through = radiance(portals.level(), ahead(Vec3.ZERO), 0.4);
            float[] moved = radiance(level(beyond).level(), ahead(away), 0.4);
            int compared = 0;
            for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
                boolean isInside = Math.abs(pixel % SIZE - SIZE / 2) < 11 && Math.abs(pixel / SIZE - SIZE / 2) < 11;
                for (int i = 3 * pixel; isInside && i < 3 * pixel + 3; i++) {
                    assertEquals(moved[i], through[i], 3e-4 + 4e-3 * moved[i], kind + ", value " + i);
                    compared += Math.abs(moved[i] - DUSK.x()) > 0.05 ? 1 : 0;
                }
            }
            assertTrue(compared > 50, "nothing behind the portal");
        }
    }

    @Test
    void surfacesHideWhatIsBehindThem() {
        Vec3 wall = new Vec3(0, 0, -1.5);
        for (Kind kind : Kind.values()) {
            TestLevel bare = level().box(null, wall, new Vec3(20, 20, 0.1));
            TestLevel hidden = level(emitter(kind)).box(null, wall, new Vec3(20, 20, 0.1));
            assertArrayEquals(
                    radiance(bare.level(), ahead(Vec3.ZERO), 0.4), radiance(hidden.level(), ahead(Vec3.ZERO), 0.4));
        }
    }

    /** Flames that a black floor cuts fade towards it: their light differs by little from row to row. */
    @Test
    void particlesFadeWhereTheyMeetAFloor() {
        Vec3 low = new Vec3(0, -1, -5);
        Emitter wide =
                new Emitter("e", Kind.FIRE, low.plus(new Vec3(0, 0.1, 0)), new Vec3(2, 0.5, 2), 10, 5, -20, 0, 4);
        Level level = new TestLevel()
                .emitter(wide)
                .box(null, low.plus(new Vec3(0, -0.5, 0)), new Vec3(40, 1, 40))
                .level();
        float[] seen = radiance(level, offscreen.view(new Vec3(0, 4, -1), low), 0);
        double steepest = 0;
        double most = 0;
        for (int i = 3 * SIZE; i < seen.length; i++) {
            most = Math.max(most, seen[i]);
            steepest = Math.max(steepest, Math.abs(seen[i] - seen[i - 3 * SIZE]));
        }
        assertTrue(most > 0.1, "too faint: " + most);
        assertTrue(steepest < 0.6 * most, "an edge: " + steepest + " of " + most);
    }

    /** 3,600 directions all around from among all kinds, straight up and down included. */
    @Test
    void everyDirectionIsFinite() {
        TestLevel all = new TestLevel().sky(new Sky.Constant(DUSK)).box(null, new Vec3(0, -4, 0), new Vec3(9, 1, 9));
        for (Kind kind : Kind.values()) {
            all.emitter(new Emitter(kind.name(), kind, Vec3.ZERO, new Vec3(3, 3, 3), 12, 5, -20.2, 5, 0));
        }
        Level level = all.level();
        try (RenderTarget small = RenderTarget.picture(offscreen.gl, "small", PixelFormat.RGBA8, 4, 4);
                Renderer renderer =
                        LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, RenderSettings.of(Output.HDR))) {
            for (int i = 0; i < 3600; i++) {
                double pitch = Math.PI * (i / 60 / 59.0 - 0.5);
                double yaw = 2 * Math.PI * (i % 60) / 60;
                Vec3 towards =
                        new Vec3(Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw));
                renderer.draw(offscreen.view(Vec3.ZERO, towards), small);
                for (float value : renderer.readRadiance()) {
                    assertTrue(value >= 0 && value < 65504, "direction " + i + ": " + value);
                }
            }
            offscreen.gl.requireNoError("directions");
        }
    }

    @Test
    void withoutARateThereIsNoPass() {
        Emitter nothing = new Emitter("e", Kind.SMOKE, CENTRE, new Vec3(3, 3, 3), 0);
        try (Renderer renderer = LevelRenderer.load(
                offscreen.gl, level(nothing).level(), TestAssets.NONE, RenderSettings.of(Output.HDR))) {
            assertFalse(
                    renderer.stepNames().contains("particle"),
                    renderer.stepNames().toString());
        }
        try (Renderer renderer = LevelRenderer.load(
                offscreen.gl, level(emitter(Kind.SMOKE)).level(), TestAssets.NONE, RenderSettings.of(Output.HDR))) {
            assertTrue(
                    renderer.stepNames().contains("particle"),
                    renderer.stepNames().toString());
        }
    }

    /** Outputs DIRECT and HDR blend differently, but draw the same particles. */
    @Test
    void directOutputShowsThem() {
        Emitter wide = new Emitter("e", Kind.QUADS, CENTRE, new Vec3(3, 3, 3), 60, 5, -20, 0, 0.8);
        int[] with = offscreen.pixels(
                level(wide).level(), TestAssets.NONE, ahead(Vec3.ZERO), RenderSettings.of(Output.DIRECT));
        int[] without =
                offscreen.pixels(level().level(), TestAssets.NONE, ahead(Vec3.ZERO), RenderSettings.of(Output.DIRECT));
        int brighter = 0;
        for (int i = 0; i < with.length; i++) {
            brighter += Offscreen.red(with[i]) > Offscreen.red(without[i]) + 5 ? 1 : 0;
        }
        assertTrue(brighter > 20, brighter + " brighter pixels");
    }
}
