package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.pass.muzzle.MuzzleLightPass;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.MuzzleLight;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.junit.jupiter.api.Test;

/** A shot lights the walls near it in its portal's colour, also those behind openings; without one nothing changes. */
class MuzzleLightGlTest {
    private static final int WIDTH = 97;
    private static final int HEIGHT = 55;
    private static final int MIDDLE = HEIGHT / 2 * WIDTH + WIDTH / 2;
    private static final int CORNER = 3 * WIDTH + 3;
    private static final Vec3 EYE = new Vec3(0, 1.5, -5);

    private static Level hall() {
        return RoomLevel.hall().gun().level();
    }

    /** A portal before the eye, which leads to the wall on the left. */
    private static Level portals() {
        return RoomLevel.hall()
                .gun()
                .pair(new Vec3(0, 1.3, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.3, 4), new Vec3(1, 0, 0))
                .level();
    }

    private static boolean isRequired(Level level, CharacterPresence character, Output output) {
        PlacedLevel placed = PlacedLevel.of(level, NoFiles.AT_ALL);
        FrameRequest request = FrameRequest.of(level, placed.statics(), null, output, Quality.HIGH, character);
        return FramePlan.of(request).steps().stream()
                .anyMatch(step -> step.feature() == MuzzleLightPass.FEATURE
                        && !step.required().isEmpty());
    }

    @Test
    void onlyAPlayerWithAGunRequiresIt() {
        assertTrue(isRequired(hall(), CharacterPresence.POSSIBLE, Output.DIRECT));
        assertTrue(!isRequired(hall(), CharacterPresence.NEVER, Output.DIRECT), "a picture without its player");
        assertTrue(!isRequired(hall(), CharacterPresence.POSSIBLE, Output.PLAIN), "a picture without light");
        assertTrue(!isRequired(RoomLevel.hall().level(), CharacterPresence.POSSIBLE, Output.DIRECT), "no gun");
    }

    @Test
    void aWallNearIsLitInThePortalsColour() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (Output output : new Output[] {Output.DIRECT, Output.HDR}) {
                int[] dark = draw(offscreen, hall(), output, null);
                int[] blue = draw(offscreen, hall(), output, new MuzzleLight(new Vec3(0, 1.5, -6), 0, 1));
                int[] orange = draw(offscreen, hall(), output, new MuzzleLight(new Vec3(0, 1.5, -6), 1, 1));
                int[] far = draw(offscreen, hall(), output, new MuzzleLight(new Vec3(0, 1.5, 0), 0, 1));
                int before = dark[MIDDLE];
                assertTrue(blue(blue[MIDDLE]) > blue(before) + 40, output + ": blue " + blue[MIDDLE]);
                assertTrue(blue(blue[MIDDLE]) - blue(before) > red(blue[MIDDLE]) - red(before) + 30, "blue's hue");
                assertTrue(red(orange[MIDDLE]) > red(before) + 40, output + ": orange " + orange[MIDDLE]);
                assertTrue(red(orange[MIDDLE]) - red(before) > blue(orange[MIDDLE]) - blue(before) + 30, "its hue");
                assertEquals(before, far[MIDDLE], output + ": out of reach");
            }
        }
    }

    /** The unlit room is black: the share of light that its walls are taken to reflect is known. */
    @Test
    void itIsAsBrightAsItsTwin() {
        var light = new MuzzleLight(new Vec3(0, 1.5, -6), 0, 0.5);
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer renderer = load(offscreen, hall(), Output.HDR, RenderFeatures.ALL)) {
            FrameState frameState = FrameState.atStart(hall());
            frameState.muzzleLight(light);
            renderer.draw(view(offscreen), frameState, offscreen.picture);
            float[] radiance = renderer.readRadiance();
            double blue = frameState.shotPalette().rim(0).z();
            double expected = MuzzleLight.DARK_SHARE * blue * light.displayed(2);
            assertEquals(expected, radiance[3 * MIDDLE + 2], 0.02 * expected);
        }
    }

    @Test
    void withoutAShotThePictureAndItsCallsAreTheSame() {
        List<RenderFeature> without = RenderFeatures.ALL.stream()
                .filter(feature -> feature != MuzzleLightPass.FEATURE)
                .toList();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT);
                Renderer plain = load(offscreen, portals(), Output.DIRECT, without);
                Renderer with = load(offscreen, portals(), Output.DIRECT, RenderFeatures.ALL)) {
            plain.draw(view(offscreen), FrameState.atStart(portals()), offscreen.picture);
            int[] before = offscreen.pixels();
            FrameState frameState = FrameState.atStart(portals());
            frameState.muzzleLight(new MuzzleLight(new Vec3(0, 1.5, -6), 0, 1));
            with.draw(view(offscreen), frameState, offscreen.picture);
            frameState.muzzleLight(null);
            with.draw(view(offscreen), frameState, offscreen.picture);
            assertArrayEquals(before, offscreen.pixels());
            assertEquals(plain.draws(), with.draws());
        }
    }

    @Test
    void anOpeningShowsTheLightOfItsOwnView() {
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            int[] dark = draw(offscreen, portals(), Output.DIRECT, null);
            int[] here = draw(offscreen, portals(), Output.DIRECT, new MuzzleLight(new Vec3(0, 1.5, -6), 0, 1));
            assertEquals(dark[MIDDLE], here[MIDDLE], "the opening is no surface");
            assertTrue(blue(here[CORNER]) > blue(dark[CORNER]) + 10, "the wall beside it");
            int[] there = draw(offscreen, portals(), Output.DIRECT, new MuzzleLight(new Vec3(6, 1.5, 4), 0, 1));
            assertTrue(blue(there[MIDDLE]) > blue(dark[MIDDLE]) + 10, "the wall behind it");
            assertEquals(dark[CORNER], there[CORNER], "not here");
        }
    }

    private static int red(int pixel) {
        return pixel >> 16;
    }

    private static int blue(int pixel) {
        return pixel & 0xff;
    }

    private static Renderer load(Offscreen offscreen, Level level, Output output, List<RenderFeature> features) {
        RenderSettings settings = RenderSettings.of(output, Quality.HIGH).with(CharacterPresence.POSSIBLE);
        return LevelRenderer.load(offscreen.gl, Scene.of(level, TestAssets.NONE), settings, features);
    }

    private static View view(Offscreen offscreen) {
        return offscreen.view(EYE, EYE.plus(new Vec3(0, 0, -1)));
    }

    private static int[] draw(Offscreen offscreen, Level level, Output output, MuzzleLight light) {
        try (Renderer renderer = load(offscreen, level, output, RenderFeatures.ALL)) {
            FrameState frameState = FrameState.atStart(level);
            frameState.muzzleLight(light);
            renderer.draw(view(offscreen), frameState, offscreen.picture);
            offscreen.gl.requireNoError("light of a shot");
            return offscreen.pixels();
        }
    }
}
