package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.level.appearance.SkyboxConvention;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The drawn skybox of each layout shows the function that its pictures hold, without a step at edges and corners. */
class SkyboxLayoutsGlTest {
    private static final int SIDE = 32;
    private static final int COARSE_SIDE = 4;
    private static final int PIXELS = 96;

    /** Returns the axes and the corners of the cube; the views of 90° towards the corners contain all edges. */
    private static List<Vec3> targets() {
        List<Vec3> targets = new ArrayList<>(List.of(
                new Vec3(1, 0, 0),
                new Vec3(-1, 0, 0),
                new Vec3(0, 1, 0),
                new Vec3(0, -1, 0),
                new Vec3(0, 0, 1),
                new Vec3(0, 0, -1)));
        for (int corner = 0; corner < 8; corner++) {
            targets.add(new Vec3(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1));
        }
        return targets;
    }

    @ParameterizedTest
    @EnumSource
    void theDrawnSkyIsTheWrittenFunction(SkyboxLayout layout) {
        assertDrawn(layout, SIDE, SkyboxConvention::colour, 3);
    }

    /**
     * With four pixels a side, adjacent ones differ by up to 40/255, and a step at an edge would be as large. The Java
     * twin has none (SkyboxLayoutsTest), and the picture is its twin's but for rounding.
     */
    @ParameterizedTest
    @EnumSource
    void theDrawnSkyIsItsTwinAtEdgesAndCorners(SkyboxLayout layout) {
        TestAssets assets = SkyboxConvention.assets(layout, COARSE_SIDE);
        SkyRadiance twin = SkyRadiance.of(
                        sky(layout), id -> PictureDecoder.decode(id, assets.bytes(id)), ColourDecoding.AS_STORED)
                .orElseThrow();
        assertDrawn(layout, COARSE_SIDE, ray -> twin.from(ray.x, ray.y, ray.z), 1.1);
    }

    /** @param tolerance of each channel, in 255ths */
    private static void assertDrawn(
            SkyboxLayout layout, int side, Function<Vector3d, Vector3d> colour, double tolerance) {
        try (Offscreen offscreen = new Offscreen(PIXELS, PIXELS);
                Renderer renderer = renderer(offscreen, layout, side)) {
            for (Vec3 target : targets()) {
                View view = offscreen.view(Vec3.ZERO, target);
                renderer.draw(view, offscreen.picture);
                int[] drawn = offscreen.pixels();
                for (int i = 0; i < drawn.length; i++) {
                    Vector3d expected = colour.apply(ray(view, i)).mul(255);
                    String at = layout + " towards " + target + ", pixel " + i % PIXELS + ", " + i / PIXELS;
                    assertEquals(expected.x, Offscreen.red(drawn[i]), tolerance, at);
                    assertEquals(expected.y, Offscreen.green(drawn[i]), tolerance, at);
                    assertEquals(expected.z, Offscreen.blue(drawn[i]), tolerance, at);
                }
            }
            offscreen.gl.requireNoError("test frames");
        }
    }

    private static Vector3d ray(View view, int pixel) {
        double x = (2 * (pixel % PIXELS) + 1.0) / PIXELS - 1;
        double y = (2 * (pixel / PIXELS) + 1.0) / PIXELS - 1;
        return view.right()
                .toVector()
                .mul(x)
                .add(view.up().toVector().mul(y))
                .sub(view.back().toVector())
                .normalize();
    }

    /** OpenGL itself, given the six files as a cube texture and the direction in the world, draws the same. */
    @Test
    void theLayoutOpenglIsWhatOpenglDraws() {
        List<int[]> drawn = new ArrayList<>();
        try (Offscreen offscreen = new Offscreen(PIXELS, PIXELS);
                Renderer renderer = renderer(offscreen, SkyboxLayout.OPENGL, SIDE)) {
            for (Vec3 target : targets()) {
                renderer.draw(offscreen.view(Vec3.ZERO, target), offscreen.picture);
                drawn.add(offscreen.pixels());
            }
        }
        TestAssets assets = SkyboxConvention.assets(SkyboxLayout.OPENGL, SIDE);
        try (Offscreen offscreen = new Offscreen(PIXELS, PIXELS)) {
            offscreen.picture.bind();
            CubeTexture cube = new CubeTexture(SkyboxConvention.names(SkyboxLayout.OPENGL, "png"), assets);
            for (int i = 0; i < drawn.size(); i++) {
                Vec3 target = targets().get(i);
                cube.draw(offscreen.view(Vec3.ZERO, target));
                assertAlike(offscreen.pixels(), drawn.get(i), "towards " + target);
            }
            cube.close();
            offscreen.gl.requireNoError("cube texture");
        }
    }

    private static void assertAlike(int[] expected, int[] drawn, String view) {
        for (int i = 0; i < drawn.length; i++) {
            String at = view + ", pixel " + i % PIXELS + ", " + i / PIXELS;
            assertEquals(Offscreen.red(expected[i]), Offscreen.red(drawn[i]), 2, at);
            assertEquals(Offscreen.green(expected[i]), Offscreen.green(drawn[i]), 2, at);
            assertEquals(Offscreen.blue(expected[i]), Offscreen.blue(drawn[i]), 2, at);
        }
    }

    private static Sky.Skybox sky(SkyboxLayout layout) {
        return new Sky.Skybox(layout, SkyboxConvention.names(layout, "png"));
    }

    private static Renderer renderer(Offscreen offscreen, SkyboxLayout layout, int side) {
        TestAssets assets = SkyboxConvention.assets(layout, side);
        return LevelRenderer.load(
                offscreen.gl, new TestLevel().sky(sky(layout)).level(), assets, RenderSettings.of(Output.PLAIN));
    }
}
