package nephele.engine.scene.impostor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.Picture;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.billboard.PlantedModels.Kind;
import nephele.engine.level.placed.MeshAssets;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;

class KindPictureTest {
    private static final Material GREEN =
            new Material("m", new Vec3(0.2, 0.6, 0.1), null, null, null, null, Vec3.ZERO, 1);

    private static Picture picture(String file) {
        KindShape shape = KindShape.of(new Kind(new MeshAssets(TestAssets.NONE).mesh(file), new Matrix4d(), null));
        return ImpostorAtlas.sprite(shape, GREEN, null, ColourDecoding.AS_STORED, 64);
    }

    @Test
    void aBallTouchesAllFourSidesAndHasItsColour() {
        Picture ball = picture("sphere_1_64_48.3d");
        assertEquals(60, ball.width());
        assertEquals(60, ball.height());
        double covered = 0;
        for (int i = 0; i < 60 * 60; i++) {
            int alpha = ball.sample(i % 60, i / 60, 3);
            covered += alpha / 255.0 / (60 * 60);
            assertEquals(alpha > 0 ? 0.6 * 255 : 0, ball.sample(i % 60, i / 60, 1), 1, "straight alpha");
        }
        assertEquals(Math.PI / 4, covered, 0.01);
        for (int side = 0; side < 4; side++) {
            int x = side == 0 ? 0 : side == 1 ? 59 : 30;
            int y = side == 2 ? 0 : side == 3 ? 59 : 30;
            assertTrue(ball.sample(x, y, 3) > 100, x + ", " + y);
        }
    }

    /** A cone stands on its base, and its tip is above. */
    @Test
    void rowsBeginAtTheTop() {
        Picture cone = picture("cone_1_2_32_16.3d");
        assertEquals(0, cone.sample(8, 8, 3));
        assertEquals(255, cone.sample(8, 56, 3));
    }
}
