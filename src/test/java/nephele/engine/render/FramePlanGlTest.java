package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The passes of a plan declare their dependencies, and closing leaves nothing behind. */
class FramePlanGlTest {
    private static TestLevel everything() {
        return new TestLevel()
                .castingSun(new Vec3(0.2, 1, 0.1), 2)
                .skyLight()
                .sky(new Sky.Gradient(TestLevel.grey(0.1), TestLevel.grey(0.5), TestLevel.grey(0.2)))
                .textured("tiles", "tiles.png")
                .material(new Material("metal", TestLevel.grey(0.7), null, 0.4, 1.0, null, Vec3.ZERO, 1))
                .light(new Light.Point("lamp", new Vec3(0, 2, 0), TestLevel.grey(4), 10, true))
                .box("tiles", new Vec3(0, -1, 0), new Vec3(9, 1, 9))
                .box("metal", new Vec3(0, 0, -2), new Vec3(1, 1, 1));
    }

    private static TestLevel plain() {
        return new TestLevel()
                .ambient(1)
                .textured("tiles", "tiles.png")
                .box("tiles", new Vec3(0, 0, -2), new Vec3(1, 1, 1));
    }

    private static TestAssets tiles() {
        return new TestAssets().picture("tiles.png", 8, 8, (x, y) -> 0x808080);
    }

    /** Loading and closing 100 levels restores the count of live objects. */
    @Test
    void aHundredLevelsLeaveNothingBehind() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            var before = offscreen.gl.live().counts();
            View view = offscreen.view(new Vec3(0, 1, 3), Vec3.ZERO);
            for (Output output : Output.values()) {
                offscreen.pixels(everything().level(), tiles(), view, RenderSettings.of(output));
            }
            for (int i = 3; i < 100; i++) {
                // Every tenth level has all features: compilation of their shaders takes most of the time.
                TestLevel level = i % 10 == 0 ? everything() : plain();
                RenderSettings settings = RenderSettings.of(Output.values()[i % 3], Quality.LOW);
                LevelRenderer.load(offscreen.gl, level.level(), tiles(), settings)
                        .close();
            }
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    @Test
    void aLevelThatCannotBeLoadedLeavesNothingBehind() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            var before = offscreen.gl.live().counts();
            Level level = everything().textured("lost", "lost.png").level();
            assertThrows(
                    AssetException.class,
                    () -> LevelRenderer.load(offscreen.gl, level, tiles(), RenderSettings.of(Output.DIRECT)));
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    /** The empty level is one clear, without draws or compilation. */
    @Test
    void theEmptyLevelIsOneClear() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            var before = offscreen.gl.live().counts();
            try (Renderer renderer = LevelRenderer.load(
                    offscreen.gl, new TestLevel().level(), TestAssets.NONE, RenderSettings.of(Output.DIRECT))) {
                renderer.draw(offscreen.view(Vec3.ZERO, new Vec3(1, 0, 0)), offscreen.picture);
                assertEquals(0, renderer.draws());
                assertEquals(before, offscreen.gl.live().counts());
            }
        }
    }

    /** The twin repeats the engine's frames bit for bit, also after foreign use of the context. */
    @ParameterizedTest
    @EnumSource
    void theBareTwinDrawsTheSamePictures(Output output) {
        try (Offscreen offscreen = new Offscreen(64, 64);
                Renderer renderer =
                        LevelRenderer.load(offscreen.gl, everything().level(), tiles(), RenderSettings.of(output))) {
            List<View> views =
                    List.of(offscreen.view(new Vec3(0, 1, 3), Vec3.ZERO), offscreen.view(new Vec3(3, 1, 1), Vec3.ZERO));
            try (BareTwin twin = new BareTwin(offscreen.gl, renderer, views, offscreen.picture)) {
                for (int frame = 0; frame < 4; frame++) {
                    renderer.draw(views.get(frame % 2), offscreen.picture);
                    int[] expected = offscreen.pixels();
                    offscreen.picture.clear(1, 0, 1);
                    twin.draw(frame);
                    assertArrayEquals(expected, offscreen.pixels());
                }
            }
        }
    }

    /** The twin binds the light lists too ({@code GL_TEXTURE_BUFFER}), although another level has bound its own. */
    @Test
    void theBareTwinBindsItsOwnLights() {
        Level red = everything()
                .light(new Light.Point("red", new Vec3(1, 1, 1), new Vec3(9, 0, 0), 10, false))
                .level();
        RenderSettings settings = RenderSettings.of(Output.DIRECT);
        try (Offscreen offscreen = new Offscreen(64, 64);
                Renderer renderer = LevelRenderer.load(offscreen.gl, red, tiles(), settings);
                Renderer other = LevelRenderer.load(offscreen.gl, everything().level(), tiles(), settings)) {
            View view = offscreen.view(new Vec3(0, 1, 3), Vec3.ZERO);
            renderer.draw(view, offscreen.picture);
            int[] expected = offscreen.pixels();
            try (BareTwin twin = new BareTwin(offscreen.gl, renderer, List.of(view), offscreen.picture)) {
                other.draw(view, offscreen.picture);
                assertFalse(Arrays.equals(expected, offscreen.pixels()));
                twin.draw(0);
                assertArrayEquals(expected, offscreen.pixels());
            }
        }
    }
}
