package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.Antialiasing;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.resource.PictureHistory;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames are averaged: at rest towards the picture with many samples, in motion along what moves, and never over a cut. */
class TemporalGlTest {
    private static final int SIZE = 96;
    private static final int TIMES = 8;
    private static final int SETTLED = PictureHistory.POINTS;
    private static final Vec3 AWAY = new Vec3(300, 0, 0);
    private static final double WALL_Z = -9;

    private static RenderSettings averaged(double resolution) {
        Quality quality =
                Quality.HIGH.with("antialiasing", Antialiasing.TEMPORAL).with("pictureResolution", resolution);
        return RenderSettings.of(Output.PLAIN).with(quality);
    }

    /** Returns a closed room of boxes around a centre. */
    private static TestLevel room(TestLevel level, Vec3 centre) {
        Random random = new Random(5);
        for (int i = 0; i < 12; i++) {
            Vec3 place = new Vec3(random.nextInt(-6, 7), random.nextInt(-4, 5), random.nextInt(-7, -2) + 0.5);
            level.box("m" + i % 3, centre.plus(place), new Vec3(0.7, 0.4 + 0.1 * i, 0.6));
        }
        for (int side = -1; side <= 1; side += 2) {
            level.box("wall", centre.plus(new Vec3(10 * side, 0, 0)), new Vec3(1, 20, 20));
            level.box("wall", centre.plus(new Vec3(0, 10 * side, 0)), new Vec3(20, 1, 20));
            level.box("wall", centre.plus(new Vec3(0, 0, -side * (WALL_Z - 0.5))), new Vec3(20, 20, 1));
        }
        return level;
    }

    private static TestLevel materials() {
        return new TestLevel()
                .ambient(1)
                .material("wall", TestLevel.grey(0.2))
                .material("m0", new Vec3(0.8, 0.3, 0.2))
                .material("m1", new Vec3(0.9, 0.9, 0.8))
                .material("m2", new Vec3(0.1, 0.5, 0.7));
    }

    private static Level oneRoom() {
        return room(materials(), Vec3.ZERO).level();
    }

    /** Two equal rooms; a portal in the middle of the first leads to the middle of the other one. */
    private static Level twoRooms() {
        return room(room(materials(), Vec3.ZERO), AWAY)
                .portal("a", "b", Vec3.ZERO, new Vec3(0, 0, 1), 3, 3)
                .portal("b", "a", AWAY, new Vec3(0, 0, -1), 3, 3)
                .level();
    }

    private static View looking(Vec3 eye) {
        return View.lookAt(
                eye, eye.plus(new Vec3(0.3, 0.1, -4)), new Vec3(0.2, 1, 0), new Projection(1.2, 1, 0.05, 1000));
    }

    private static double linear(int code) {
        return ToneMapping.decodeSrgb(code / 255.0);
    }

    private static double[] exact(Level level, View view) {
        int side = SIZE * TIMES;
        double[] mean = new double[SIZE * SIZE];
        try (var offscreen = new Offscreen(side, side)) {
            int[] many = offscreen.pixels(level, TestAssets.NONE, view, RenderSettings.of(Output.PLAIN));
            for (int i = 0; i < many.length; i++) {
                mean[i / side / TIMES * SIZE + i % side / TIMES] += linear(Offscreen.red(many[i])) / (TIMES * TIMES);
            }
        }
        return mean;
    }

    private static double rms(int[] picture, double[] exact) {
        return Math.sqrt(IntStream.range(0, exact.length)
                .mapToDouble(i -> Math.pow(linear(Offscreen.red(picture[i])) - exact[i], 2))
                .average()
                .orElseThrow());
    }

    private static int difference(int a, int b) {
        return Math.max(
                Math.abs(Offscreen.red(a) - Offscreen.red(b)),
                Math.max(
                        Math.abs(Offscreen.green(a) - Offscreen.green(b)),
                        Math.abs(Offscreen.blue(a) - Offscreen.blue(b))));
    }

    private static long differing(int[] a, int[] b, int codes) {
        return IntStream.range(0, a.length)
                .filter(i -> difference(a[i], b[i]) > codes)
                .count();
    }

    private static List<int[]> frames(Offscreen offscreen, Renderer renderer, View... views) {
        List<int[]> frames = new ArrayList<>();
        for (View view : views) {
            renderer.draw(view, offscreen.picture);
            frames.add(offscreen.pixels());
        }
        offscreen.gl.requireNoError("frames");
        return frames;
    }

    private static View[] atRest(View view, int frames) {
        View[] views = new View[frames];
        Arrays.fill(views, view);
        return views;
    }

    private static Renderer load(Offscreen offscreen, Level level, RenderSettings settings) {
        return LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings);
    }

    /** Also from fewer pixels than the picture has, and through a portal; afterwards the picture hardly changes. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.75})
    void aViewAtRestBecomesThePictureWithManySamples(double resolution) {
        View view = looking(new Vec3(0.1, 0.2, 1));
        double[] exact = exact(twoRooms(), view);
        try (var offscreen = new Offscreen(SIZE, SIZE);
                var renderer = load(offscreen, twoRooms(), averaged(resolution))) {
            double without =
                    rms(offscreen.pixels(twoRooms(), TestAssets.NONE, view, RenderSettings.of(Output.PLAIN)), exact);
            List<int[]> frames = frames(offscreen, renderer, atRest(view, 3 * SETTLED));
            double with = rms(frames.get(SETTLED - 1), exact);
            assertTrue(with <= 0.6 * without, with + " of " + without);
            for (int i = SETTLED; i < frames.size(); i++) {
                // One pixel in a thousand, at thin lines, takes further frames.
                long changed = differing(frames.get(SETTLED - 1), frames.get(i), 1);
                assertTrue(changed <= SIZE * SIZE / 1000, changed + " pixels");
            }
        }
    }

    @Test
    void afterACutFramesAreThoseOfAColdStart() {
        View[] views = {looking(new Vec3(0.1, 0.2, 1)), looking(new Vec3(0.2, 0.2, 1)), looking(new Vec3(0.2, 0.2, 1))};
        try (var offscreen = new Offscreen(SIZE, SIZE);
                var cold = load(offscreen, twoRooms(), averaged(0.75));
                var warm = load(offscreen, twoRooms(), averaged(0.75))) {
            List<int[]> expected = frames(offscreen, cold, views);
            frames(offscreen, warm, atRest(looking(new Vec3(-1, 0.5, 3)), 5));
            warm.forget();
            List<int[]> actual = frames(offscreen, warm, views);
            for (int i = 0; i < views.length; i++) {
                assertArrayEquals(expected.get(i), actual.get(i));
            }
            assertFalse(Arrays.equals(expected.get(1), expected.get(2)));
        }
    }

    /** What a step to the side uncovers is after eight frames as if it had always been seen. */
    @Test
    void whatWasHiddenIsFinalAfterEightFrames() {
        View before = looking(new Vec3(0.1, 0.2, 1));
        View after = looking(new Vec3(0.9, 0.2, 1));
        RenderSettings single = RenderSettings.of(Output.PLAIN);
        try (var offscreen = new Offscreen(SIZE, SIZE);
                var moved = load(offscreen, oneRoom(), averaged(0.75));
                var always = load(offscreen, oneRoom(), averaged(0.75))) {
            int[] hiding = offscreen.pixels(oneRoom(), TestAssets.NONE, before, single);
            int[] uncovering = offscreen.pixels(oneRoom(), TestAssets.NONE, after, single);
            frames(offscreen, moved, atRest(before, 20));
            moved.draw(after, offscreen.picture);
            int[] eighth = frames(offscreen, moved, atRest(after, SETTLED)).get(SETTLED - 1);
            int[] exact = frames(offscreen, always, atRest(after, SETTLED)).get(SETTLED - 1);
            int uncovered = 0;
            for (int i = 2 * SIZE; i < eighth.length - 2 * SIZE; i++) {
                // The wall is so far that it hardly moves; pixels at edges see something else beside.
                boolean isWall = uncovering[i] == 0x333333
                        && uncovering[i - 2] == 0x333333
                        && uncovering[i + 2] == 0x333333
                        && uncovering[i - 2 * SIZE] == 0x333333
                        && uncovering[i + 2 * SIZE] == 0x333333;
                if (isWall && hiding[i] != 0x333333) {
                    uncovered++;
                    assertTrue(
                            difference(exact[i], eighth[i]) <= 1,
                            "pixel " + i + ": " + Integer.toHexString(eighth[i]) + " " + Integer.toHexString(exact[i]));
                }
            }
            assertTrue(uncovered > 100, uncovered + " pixels");
        }
    }

    /** On a walk through a portal into an equal room all frames are those of a walk without the portal. */
    @Test
    void aWalkThroughAPortalIsAsOneWithout() {
        View[] within = new View[12];
        View[] through = new View[within.length];
        for (int i = 0; i < within.length; i++) {
            Vec3 eye = new Vec3(0.02 * i, 0.2, 0.55 - 0.1 * i);
            within[i] = looking(eye);
            through[i] = eye.z() > 0 ? within[i] : looking(eye.plus(AWAY));
        }
        try (var offscreen = new Offscreen(SIZE, SIZE);
                var one = load(offscreen, oneRoom(), averaged(0.75));
                var two = load(offscreen, twoRooms(), averaged(0.75).with(RenderSettings.Decoration.OFF))) {
            List<int[]> expected = frames(offscreen, one, within);
            List<int[]> actual = frames(offscreen, two, through);
            for (int i = 0; i < within.length; i++) {
                long differing = differing(expected.get(i), actual.get(i), 4);
                assertTrue(differing <= 30, "frame " + i + ": " + differing + " pixels");
            }
        }
    }
}
