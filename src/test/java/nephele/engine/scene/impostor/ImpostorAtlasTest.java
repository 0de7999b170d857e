package nephele.engine.scene.impostor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.billboard.PlantedModels.Kind;
import nephele.engine.level.placed.MeshAssets;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Atlases of shapes whose views are known. */
@Execution(ExecutionMode.CONCURRENT)
class ImpostorAtlasTest {
    private static final int TEXELS = 32;
    private static final Material GREEN =
            new Material("m", new Vec3(0.2, 0.6, 0.1), null, null, null, null, Vec3.ZERO, 1);

    private static KindShape shape(String file) {
        return KindShape.of(new Kind(new MeshAssets(TestAssets.NONE).mesh(file), new Matrix4d(), null));
    }

    private static ImpostorAtlas atlas(String file) {
        return ImpostorAtlas.of(shape(file), GREEN, null, ColourDecoding.AS_STORED, TEXELS);
    }

    private static int code(byte[] image, int x, int y, int channel) {
        return image[4 * (y * ImpostorAtlas.SIDE * TEXELS + x) + channel] & 0xff;
    }

    /** From each direction a ball is an ellipse of the view's rectangle, faces the viewer and reaches towards it. */
    @Test
    void everyViewOfABallShowsItWhole() {
        KindShape ball = shape("sphere_1_64_48.3d");
        ImpostorAtlas atlas = atlas("sphere_1_64_48.3d");
        byte[] colours = atlas.colours().get(0);
        byte[] shapes = atlas.shapes().get(0);
        for (int view = 0; view < ImpostorAtlas.SIDE * ImpostorAtlas.SIDE; view++) {
            int left = view % ImpostorAtlas.SIDE * TEXELS;
            int bottom = view / ImpostorAtlas.SIDE * TEXELS;
            AtlasView own = AtlasView.at(view % ImpostorAtlas.SIDE, view / ImpostorAtlas.SIDE, ball);
            double covered = 0;
            for (int i = 0; i < TEXELS * TEXELS; i++) {
                int alpha = code(colours, left + i % TEXELS, bottom + i / TEXELS, 3);
                covered += alpha / 255.0 / (TEXELS * TEXELS);
                boolean isEdge = i % TEXELS == 0 || i / TEXELS == 0;
                assertTrue(!isEdge || alpha == 0, "the border of view " + view);
            }
            double expected = Math.PI / 4 * ImpostorAtlas.FILLED * ImpostorAtlas.FILLED / own.halfHeight();
            assertEquals(expected, covered, 0.01, "view " + view);
            int x = left + TEXELS / 2;
            int y = bottom + TEXELS / 2;
            assertEquals(255, code(colours, x, y, 3));
            assertEquals(255 * 0.6, code(colours, x, y, 1), 1);
            assertEquals(1, code(shapes, x, y, 3) / 127.5 - 1, 0.02, "depth of view " + view);
            Vec3 normal = new Vec3(code(shapes, x, y, 0), code(shapes, x, y, 1), code(shapes, x, y, 2))
                    .scaled(1 / 127.5)
                    .minus(new Vec3(1, 1, 1));
            assertTrue(normal.dot(own.towards()) > 0.98, "normal of view " + view);
        }
    }

    /** Smaller sizes keep the mean coverage, and colours stay those of what is covered. */
    @Test
    void smallerSizesCoverAsMuch() {
        ImpostorAtlas atlas = atlas("torus_1_0.2_32_12.3d");
        assertEquals(9, atlas.colours().size());
        double whole = mean(atlas.colours().get(0), 3);
        assertTrue(whole > 20);
        for (byte[] level : atlas.colours()) {
            assertEquals(whole, mean(level, 3), 1);
            assertEquals(0.6, mean(level, 1) / mean(level, 3), 0.02);
        }
    }

    private static double mean(byte[] image, int channel) {
        double sum = 0;
        for (int i = channel; i < image.length; i += 4) {
            sum += image[i] & 0xff;
        }
        return sum / (image.length / 4);
    }

    /** A ball hides no sky from itself but that below the ground; its top sees all, its bottom none. */
    @Test
    void theSkyOfABallGrowsWithItsHeight() {
        KindShape ball = shape("sphere_1_32_16.3d");
        KindSky sky = KindSky.of(ball);
        for (int i = 0; i < sky.ofCorner().length; i++) {
            double y = ball.triangles().corner(i / 3, i % 3).y();
            assertEquals((1 + y) / 2, sky.ofCorner()[i], 0.15);
        }
        float[] fit = sky.fit();
        assertEquals(1, fit[0] + fit[1] + fit[2], 0.15);
        assertEquals(0, fit[0] - fit[1] + fit[2], 0.15);
    }

    @Test
    void viewsHaveAsManyTexelsAsPixelsNeed() {
        assertEquals(64, ImpostorAtlas.texelsFor(64));
        assertEquals(128, ImpostorAtlas.texelsFor(65));
        assertEquals(16, ImpostorAtlas.texelsFor(0));
        assertEquals(256, ImpostorAtlas.texelsFor(1e9));
    }
}
