package nephele.engine.render.pass.billboard;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.billboard.FacingAxes;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Billboards face an observer's sphere, whatever the eye; the sphere has the colour of its contact. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ObserverGlTest {
    private static final int SIZE = 64;
    private static final int SKY = 0x0000ff;
    private static final int LEFT = 0xff0000;
    private static final int RIGHT = 0x00ff00;
    private static final Vec3 FOOT = new Vec3(0.5, -1, -4);
    private static final Vec3 MIDDLE = FOOT.plus(new Vec3(0, 1.2, 0));
    private static final List<Vec3> EYES =
            List.of(new Vec3(0, 0.3, 0), new Vec3(4.2, 1.5, -3.1), new Vec3(-2, 0.2, -7.5));

    private final Offscreen offscreen = new Offscreen(SIZE, SIZE);
    private final TestAssets assets = new TestAssets().picture("card.png", 16, 16, (x, y) -> x < 8 ? LEFT : RIGHT);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static TestLevel lit() {
        return new TestLevel().sky(new Sky.Constant(new Vec3(0, 0, 1))).ambient(1);
    }

    /** Returns a level with an observer whose sphere has its centre at a place. */
    private static Level observed(TestLevel level, Vec3 centre) {
        var observer = new Level.Observer(null, 0.5, Bound.SPHERE);
        return level.level()
                .with(new PlayerStart(centre.minus(new Vec3(0, 0.5, 0)), 0, 0), null)
                .withObserver(observer);
    }

    private static int expected(FacingAxes axes, View view, Vec3 ray) {
        Vec3 toMiddle = MIDDLE.minus(view.eye());
        double distance = toMiddle.dot(axes.front()) / ray.dot(axes.front());
        Vec3 at = ray.scaled(distance).minus(toMiddle);
        double x = at.dot(axes.right());
        boolean isMet = distance > 0 && Math.abs(x) < 1 && Math.abs(at.dot(axes.up())) < 1.2;
        return !isMet ? SKY : x < 0 ? LEFT : RIGHT;
    }

    /** The observer is behind the billboard or far to its side, where the formula of the source faces away. */
    @ParameterizedTest
    @EnumSource(
            value = Facing.class,
            names = {"CROSSED"},
            mode = EnumSource.Mode.EXCLUDE)
    void billboardsFaceTheObserver(Facing facing) {
        var card = Billboards.at("b", "card.png", facing, 2, 2.4, List.of(FOOT));
        double turn = new PlantedBillboards.Group(card, List.of(FOOT)).turn(0);
        Facing faced = facing == Facing.SCREEN ? Facing.SPHERICAL : facing;
        for (Vec3 observer : List.of(new Vec3(90, 40, -70), new Vec3(-80, -30, 60))) {
            FacingAxes axes = FacingAxes.of(faced, observer.minus(MIDDLE), new Vec3(1, 0, 0), new Vec3(0, 1, 0), turn);
            Level level = observed(lit().billboards(card), observer);
            for (Vec3 eye : EYES) {
                View view = offscreen.view(eye, MIDDLE);
                int[] drawn = offscreen.pixels(level, assets, view, RenderSettings.of(Output.PLAIN));
                int wrong = 0;
                for (int i = 0; i < drawn.length; i++) {
                    wrong += drawn[i] == expected(axes, view, offscreen.ray(view, i)) ? 0 : 1;
                }
                assertTrue(wrong < 100, facing + " from " + eye + ": " + wrong);
            }
        }
    }

    @Test
    void theSphereHasTheColourOfItsContact() {
        Vec3 centre = new Vec3(0, 0, -3);
        Level level = observed(lit(), centre);
        View view = offscreen.view(Vec3.ZERO, centre);
        Scene scene = Scene.of(level, assets);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, scene, RenderSettings.of(Output.PLAIN))) {
            var state = FrameState.atStart(level);
            assertEquals(new ObserverSphere(centre, 0.5, false), state.observer());
            int apart = middle(renderer, view, state);
            state.observer(new ObserverSphere(centre, 0.5, true));
            int touching = middle(renderer, view, state);
            state.observer(new ObserverSphere(new Vec3(0, 9, -3), 0.5, true));
            assertEquals(SKY, middle(renderer, view, state));
            assertTrue(Offscreen.blue(apart) > Offscreen.red(apart), Integer.toHexString(apart));
            assertTrue(Offscreen.red(touching) > Offscreen.blue(touching), Integer.toHexString(touching));
        }
    }

    private int middle(Renderer renderer, View view, FrameState state) {
        renderer.draw(view, state, offscreen.picture);
        return offscreen.pixels()[SIZE / 2 * SIZE + SIZE / 2];
    }

    /** The shadow of a card that faces along x is a line for a sun above it, and wide for an observer towards z. */
    @Test
    void shadowsTurnWithTheObserver() {
        var card = Billboards.at("b", "card.png", Facing.CYLINDRICAL, 2, 2.4, List.of(Vec3.ZERO));
        TestLevel ground = lit().castingSun(new Vec3(1, 1, 0), 3)
                .box(null, new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                .billboards(card);
        View view = offscreen.view(new Vec3(-2, 9, 0.01), new Vec3(-2, 0, 0));
        int[] facesSun = shaded(ground, view, new Vec3(500, 1, 0));
        int[] besideSun = shaded(ground, view, new Vec3(0, 1, 500));
        assertFalse(Arrays.equals(facesSun, besideSun));
        assertTrue(dark(facesSun) > 3 * dark(besideSun), dark(facesSun) + " " + dark(besideSun));
        assertArrayEquals(facesSun, shaded(ground, view, new Vec3(500, 1, 0)));
    }

    private int[] shaded(TestLevel level, View view, Vec3 observer) {
        return offscreen.pixels(observed(level, observer), assets, view, RenderSettings.of(Output.PLAIN));
    }

    /** Returns how many grey pixels, which are the ground's, are darker than most. */
    private static long dark(int[] pixels) {
        int[] grey = Arrays.stream(pixels)
                .filter(rgb ->
                        Offscreen.red(rgb) == Offscreen.green(rgb) && Offscreen.green(rgb) == Offscreen.blue(rgb))
                .map(Offscreen::green)
                .sorted()
                .toArray();
        return Arrays.stream(grey)
                .filter(value -> value < 0.8 * grey[grey.length / 2])
                .count();
    }
}
