package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/** The background is drawn correctly. */
class SkyGlTest {
    private static final List<Vec3> AXES = List.of(
            new Vec3(1, 0, 0),
            new Vec3(-1, 0, 0),
            new Vec3(0, 1, 0),
            new Vec3(0, -1, 0),
            new Vec3(0, 0, 1),
            new Vec3(0, 0, -1));
    private static final int[] COLOURS = {0xff0000, 0x00ffff, 0x00ff00, 0xff00ff, 0x0000ff, 0xffff00};

    @Test
    void theGradientIsItsJavaTwin() {
        Sky.Gradient sky = new Sky.Gradient(new Vec3(0.1, 0.3, 2), new Vec3(1, 0.9, 0.7), new Vec3(0.2, 0.1, 0));
        try (Offscreen offscreen = new Offscreen(33, 33)) {
            List<View> views = new ArrayList<>(List.of(offscreen.view(Vec3.ZERO, new Vec3(0.3, 0.1, -1))));
            AXES.forEach(axis -> views.add(offscreen.view(Vec3.ZERO, axis)));
            List<float[]> seen = offscreen.radiance(new TestLevel().sky(sky).level(), TestAssets.NONE, views);
            for (int i = 0; i < views.size(); i++) {
                isGradient(sky, views.get(i), seen.get(i));
            }
        }
    }

    private static void isGradient(Sky.Gradient sky, View view, float[] rgb) {
        for (int y = 0; y < 33; y++) {
            for (int x = 0; x < 33; x++) {
                Vector3d ray = ray(view, (2 * x + 1) / 33.0 - 1, (2 * y + 1) / 33.0 - 1);
                Vec3 expected = GradientSky.radiance(sky, ray.normalize().y);
                int at = 3 * (33 * y + x);
                assertEquals(expected.x(), rgb[at], 2e-3);
                assertEquals(expected.y(), rgb[at + 1], 2e-3);
                assertEquals(expected.z(), rgb[at + 2], 4e-3);
            }
        }
    }

    private static Vector3d ray(View view, double x, double y) {
        return view.right()
                .toVector()
                .mul(x)
                .add(view.up().toVector().mul(y))
                .sub(view.back().toVector());
    }

    @Test
    void eachFaceOfASkyboxLiesWhereItsNameSays() {
        TestAssets assets = faces();
        try (Offscreen offscreen = new Offscreen(9, 9)) {
            for (int face = 0; face < 6; face++) {
                View view = offscreen.view(new Vec3(5, 6, 7), new Vec3(5, 6, 7).plus(AXES.get(face)));
                int[] pixels = offscreen.pixels(skybox().level(), assets, view, RenderSettings.of(Output.PLAIN));
                assertEquals(COLOURS[face], pixels[40], "face " + face);
            }
        }
    }

    /** From inside, the pictures are not mirrored: looking along −z, the picture's upper left quarter is white. */
    @Test
    void skyboxPicturesStandUprightAndUnmirrored() {
        TestAssets assets = faces();
        try (Offscreen offscreen = new Offscreen(64, 64)) {
            int[] ahead = look(offscreen, assets, new Vec3(0, 0, -1));
            assertEquals(0xffffff, ahead[64 * 58 + 5]);
            assertEquals(COLOURS[5], ahead[64 * 58 + 58]);
            assertEquals(COLOURS[5], ahead[64 * 5 + 5]);
            int[] right = look(offscreen, assets, new Vec3(1, 0, 0));
            assertEquals(0xffffff, right[64 * 58 + 5]);
            // Looking up from −z without a turn, the bottom edge of the +y picture joins the top edge of the −z
            // picture.
            int[] up = look(offscreen, assets, new Vec3(0, 1, -1e-3));
            assertEquals(0xffffff, up[64 * 58 + 5]);
            int[] down = look(offscreen, assets, new Vec3(0, -1, -1e-3));
            assertEquals(0xffffff, down[64 * 58 + 5]);
        }
    }

    private static int[] look(Offscreen offscreen, TestAssets assets, Vec3 towards) {
        View view = offscreen.view(Vec3.ZERO, towards);
        return offscreen.pixels(skybox().level(), assets, view, RenderSettings.of(Output.PLAIN));
    }

    @Test
    void aCrossShowsTheSameAsItsFaces() {
        int[][] cells = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}};
        TestAssets assets = faces().picture("cross.png", 64, 48, (x, y) -> {
            for (int face = 0; face < 6; face++) {
                if (x / 16 == cells[face][0] && y / 16 == cells[face][1]) {
                    return faceColour(face, x % 16, y % 16);
                }
            }
            return 0x123456;
        });
        Level cross = new TestLevel()
                .sky(new Sky.Skybox(SkyboxLayout.CROSS, List.of("cross.png")))
                .level();
        try (Offscreen offscreen = new Offscreen(48, 48)) {
            for (Vec3 axis : AXES) {
                View view = offscreen.view(Vec3.ZERO, axis.plus(new Vec3(0.2, 0.1, 0.3)));
                RenderSettings direct = RenderSettings.of(Output.DIRECT);
                assertArrayEquals(
                        offscreen.pixels(skybox().level(), assets, view, direct),
                        offscreen.pixels(cross, assets, view, direct));
            }
        }
    }

    /**
     * A sky that is one smooth function over all faces shows no seam: the difference of adjacent pixels is as small as
     * elsewhere.
     */
    @Test
    void faceEdgesShowNoSeam() {
        TestAssets assets = new TestAssets();
        List<String> files = new ArrayList<>();
        for (int face = 0; face < 6; face++) {
            int number = face;
            files.add("smooth" + face + ".png");
            assets.picture(files.get(face), 32, 32, (x, y) -> smooth(number, x, y));
        }
        Level level =
                new TestLevel().sky(new Sky.Skybox(SkyboxLayout.FACES, files)).level();
        try (Offscreen offscreen = new Offscreen(128, 128)) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(1, 0.8, -1));
            int[] pixels = offscreen.pixels(level, assets, view, RenderSettings.of(Output.PLAIN));
            for (int i = 1; i < pixels.length; i++) {
                if (i % 128 != 0) {
                    int step = Math.abs(Offscreen.green(pixels[i]) - Offscreen.green(pixels[i - 1]));
                    Assertions.assertTrue(step <= 5, "step of " + step + " at pixel " + i);
                }
            }
        }
    }

    private static int smooth(int face, int x, int y) {
        double s = (2 * x + 1) / 32.0 - 1;
        double t = (2 * y + 1) / 32.0 - 1;
        double[] d =
                switch (face) {
                    case 0 -> new double[] {1, -t, s};
                    case 1 -> new double[] {-1, -t, -s};
                    case 2 -> new double[] {s, 1, -t};
                    case 3 -> new double[] {s, -1, t};
                    case 4 -> new double[] {-s, -t, 1};
                    default -> new double[] {s, -t, -1};
                };
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        int value = (int) Math.round(127.5 + 40 * (d[0] + d[1] - d[2]) / length);
        return value * 0x010101;
    }

    @Test
    void facesOfDifferentSizesAreRefusedByName() {
        TestAssets assets = faces().picture("sky3.png", 8, 8, (x, y) -> 0);
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            var before = offscreen.gl.live().counts();
            AssetException problem = Assertions.assertThrows(
                    AssetException.class,
                    () -> offscreen.pixels(
                            skybox().level(),
                            assets,
                            offscreen.view(Vec3.ZERO, AXES.get(0)),
                            RenderSettings.of(Output.PLAIN)));
            Assertions.assertTrue(problem.getMessage().startsWith("sky3.png: "), problem.getMessage());
            assertEquals(before, offscreen.gl.live().counts());
        }
    }

    private static TestLevel skybox() {
        List<String> files = List.of("sky0.png", "sky1.png", "sky2.png", "sky3.png", "sky4.png", "sky5.png");
        return new TestLevel().sky(new Sky.Skybox(SkyboxLayout.FACES, files));
    }

    private static TestAssets faces() {
        TestAssets assets = new TestAssets();
        for (int face = 0; face < 6; face++) {
            int number = face;
            assets.picture("sky" + face + ".png", 16, 16, (x, y) -> faceColour(number, x, y));
        }
        return assets;
    }

    /** Returns the face's colour, white in the upper left quarter except its middle. */
    private static int faceColour(int face, int x, int y) {
        return x < 6 && y < 6 ? 0xffffff : COLOURS[face];
    }
}
