package nephele.engine.level.billboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import nephele.engine.asset.Picture;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class SpriteTest {
    private static final int SIDE = 32;

    private static boolean isInDisc(int x, int y) {
        return Math.hypot(x % SIDE - 15.5, y - 15.5) < 10;
    }

    /** Returns a green disc on black in each frame, as 24-bit BMP has it. */
    private static byte[] bmp(int frames, int background) throws IOException {
        BufferedImage image = new BufferedImage(SIDE * frames, SIDE, BufferedImage.TYPE_3BYTE_BGR);
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE * frames; x++) {
                image.setRGB(x, y, isInDisc(x, y) ? 0x20c040 : background);
            }
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "bmp", out);
        return out.toByteArray();
    }

    private static Sprite sprite(byte[] file, int frames, Vec3 key) {
        Billboards group = new Billboards(
                "b",
                "s.bmp",
                key,
                Facing.SCREEN,
                new Billboards.Size(1, 1),
                0,
                List.of(Vec3.ZERO),
                null,
                frames,
                0,
                0,
                false,
                Vec3.ZERO,
                null);
        return Sprite.of(group, new NoFiles(Map.of("s.bmp", file)));
    }

    private static int alpha(Picture picture, int x, int y) {
        return picture.sample(x, y, 3);
    }

    @Test
    void blackIsTransparentInA24BitBitmap() throws IOException {
        Picture picture = sprite(bmp(1, 0), 1, null).frames().get(0);
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                assertEquals(isInDisc(x, y) ? 255 : 0, alpha(picture, x, y));
            }
        }
    }

    @Test
    void noTexelKeepsTheColourOfTheKey() throws IOException {
        Picture picture =
                sprite(bmp(1, 0xff00ff), 1, new Vec3(1, 0, 1)).frames().get(0);
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                assertEquals(0x20, picture.sample(x, y, 0));
                assertEquals(0xc0, picture.sample(x, y, 1));
                assertEquals(0x40, picture.sample(x, y, 2));
            }
        }
    }

    @Test
    void anotherColourThanTheKeyStays() throws IOException {
        Picture picture = sprite(bmp(1, 0x000001), 1, null).frames().get(0);
        assertEquals(255, alpha(picture, 0, 0));
    }

    @Test
    void anAtlasIsCutIntoItsFrames() throws IOException {
        Sprite sprite = sprite(bmp(3, 0), 3, null);
        assertEquals(3, sprite.frames().size());
        assertEquals(SIDE, sprite.width());
        sprite.frames().forEach(frame -> assertEquals(255, alpha(frame, 15, 15)));
    }

    /** Twigs a pixel wide vanish from plain mipmaps; the drawn share stays here. */
    @Test
    void coverageIsKeptInSmallerLevels() {
        byte[] rgba = new byte[4 * 64 * 64];
        for (int i = 0; i < 64 * 64; i++) {
            int x = i % 64;
            int y = i / 64;
            boolean isTwig = (x + 2 * y) % 7 == 0 || (3 * x - y + 64) % 11 == 0 || Math.hypot(x - 30, y - 34) < 14;
            rgba[4 * i + 3] = (byte) (isTwig ? 255 : 0);
        }
        double coverage = AlphaCoverage.of(64, 64, rgba);
        byte[] level = rgba;
        for (int side = 32; side >= 4; side /= 2) {
            level = halved(level, side);
            byte[] kept = level.clone();
            AlphaCoverage.keep(coverage, side, side, kept);
            assertEquals(coverage, AlphaCoverage.of(side, side, kept), 0.02, "side " + side);
        }
        assertTrue(Math.abs(AlphaCoverage.of(4, 4, level) - coverage) > 0.05, "plain levels lose it");
    }

    private static byte[] halved(byte[] from, int side) {
        byte[] to = new byte[4 * side * side];
        for (int i = 0; i < side * side; i++) {
            int at = 4 * (i / side * 4 * side + i % side * 2) + 3;
            int sum = (from[at] & 255)
                    + (from[at + 4] & 255)
                    + (from[at + 8 * side] & 255)
                    + (from[at + 8 * side + 4] & 255);
            to[4 * i + 3] = (byte) (sum / 4);
        }
        return to;
    }
}
