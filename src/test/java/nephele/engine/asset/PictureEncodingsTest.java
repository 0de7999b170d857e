package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The bands of a file become red, green, blue and alpha by what it says that they are: the same picture in every
 * encoding has the same colours, or is refused.
 */
class PictureEncodingsTest {
    /** The most by which a colour may differ, of 255: the rounding of 8 bits of linear light. */
    private static final int MOST = 4;

    static Stream<PictureEncodings> colours() {
        return PictureEncodings.ofColours().stream();
    }

    @ParameterizedTest
    @MethodSource("colours")
    void everyEncodingHasTheColours(PictureEncodings encoded) {
        Picture picture = PictureDecoder.decode(encoded.name(), encoded.bytes()).toRgba8();
        int quarter = PictureEncodings.SIDE / 4;
        for (int i = 0; i < 4; i++) {
            int x = quarter + i % 2 * 2 * quarter;
            int y = quarter + i / 2 * 2 * quarter;
            String seen = String.format(
                    "quarter %d: %d %d %d",
                    i, picture.sample(x, y, 0), picture.sample(x, y, 1), picture.sample(x, y, 2));
            for (int channel = 0; channel < 3; channel++) {
                int expected = PictureEncodings.QUARTERS[i] >> 16 - 8 * channel & 255;
                assertEquals(expected, picture.sample(x, y, channel), MOST, seen);
            }
            assertEquals(255, picture.sample(x, y, 3), seen);
        }
    }

    @Test
    void thereAreEnoughOfThem() {
        assertTrue(colours().count() >= 40);
    }

    /** Normals and densities are numbers, whatever colours a file says that they are. */
    @Test
    void numbersStayAsTheyAreStored() {
        for (PictureEncodings encoded : PictureEncodings.ofColours()) {
            if (encoded.name().equals("gamma-1.png") || encoded.name().equals("profile-linear.png")) {
                Picture numbers = PictureDecoder.decodeNumbers(encoded.name(), encoded.bytes());
                assertEquals(0x99, numbers.toRgba8().sample(0, 0, 0), 6, "0xcc of 0xff is .604 of the light");
            }
        }
    }

    /** A JPEG that no reader here decodes says by its message what it is. */
    @Test
    void otherJpegsAreRefusedByName() {
        byte[] plain = PictureEncodings.jpeg(PictureEncodings.image(), false);
        int frame = 0;
        while ((plain[frame] & 255) != 0xff || (plain[frame + 1] & 255) != 0xc0) {
            frame++;
        }
        byte[] four = PictureEncodings.jpeg(PictureEncodings.raster(4, (x, y) -> 0x7f7f7f7f), false);
        refused("a JPEG with arithmetic coding", changed(plain, frame + 1, 0xc9));
        refused("a JPEG with arithmetic coding", changed(plain, frame + 1, 0xca));
        refused("a lossless JPEG", changed(plain, frame + 1, 0xc3));
        refused("a hierarchical JPEG", changed(plain, frame + 1, 0xc5));
        refused("a JPEG of 12 bits", changed(plain, frame + 4, 12));
        refused("a JPEG of 2 components", changed(plain, frame + 9, 2));
        refused("a JPEG of four components that does not say which colours they are", four);
    }

    @Test
    void coloursOfAHighDynamicRangeAreRefused() {
        byte[] rows = new byte[PictureEncodings.SIDE * (3 * PictureEncodings.SIDE + 1)];
        byte[] file = PictureEncodings.png(2, 8, rows, SamplePictures.chunk("cICP", new byte[] {9, 16, 0, 1}));
        var problem = assertThrows(AssetException.class, () -> PictureDecoder.decode("a.png", file));
        assertEquals("has colours of a wide or a high dynamic range (cICP 9, 16)", problem.reason());
    }

    private static byte[] changed(byte[] bytes, int at, int value) {
        byte[] copy = bytes.clone();
        copy[at] = (byte) value;
        return copy;
    }

    private static void refused(String what, byte[] bytes) {
        var problem = assertThrows(AssetException.class, () -> PictureDecoder.decode("a.jpg", bytes));
        assertEquals("a.jpg: is " + what + "; save it again as a plain JPEG in RGB, or as PNG", problem.getMessage());
    }

    /** Greys of every depth, with and without alpha, with and without a key of transparency. */
    @Test
    void greysOfEveryDepthAgree() {
        for (int bits : new int[] {1, 2, 4, 8, 16}) {
            int most = (1 << bits) - 1;
            for (boolean hasKey : new boolean[] {false, true}) {
                byte[] row = new byte[1 + (2 * bits + 7) / 8];
                if (bits < 8) {
                    row[1] = (byte) (most << 8 - 2 * bits);
                } else {
                    row[row.length - 1] = -1;
                    row[row.length - bits / 8] = -1;
                }
                byte[] pixels = SamplePictures.chunk("IDAT", SamplePictures.deflated(row));
                byte[] key = SamplePictures.chunk("tRNS", new byte[] {(byte) (most >> 8), (byte) most});
                byte[] header = SamplePictures.header(2, 1, bits, 0, 0);
                Picture picture = PictureDecoder.decode(
                                "a.png",
                                hasKey ? SamplePictures.png(header, key, pixels) : SamplePictures.png(header, pixels))
                        .toRgba8();
                String which = bits + " bits" + (hasKey ? " with a key" : "");
                assertEquals(List.of(0, 0, 0, 255), pixel(picture, 0), which);
                assertEquals(List.of(255, 255, 255, hasKey ? 0 : 255), pixel(picture, 1), which);
            }
        }
    }

    @Test
    void greyJpegsAndTgasAgree() {
        BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 64; i++) {
            image.getRaster().setSample(i % 8, i / 8, 0, 0x77);
        }
        assertEquals(
                0x77,
                PictureDecoder.decode("a.jpg", PictureEncodings.jpeg(image, false))
                        .toRgba8()
                        .sample(4, 4, 2),
                1);
        Picture grey = PictureDecoder.decode("a.tga", SamplePictures.tga(3, 1, 1, 8, new byte[] {0x77}));
        assertEquals(List.of(0x77, 0x77, 0x77, 255), pixel(grey.toRgba8(), 0));
        byte[] withAlpha = SamplePictures.tga(3, 1, 1, 16, new byte[] {0x77, 0x40});
        withAlpha[17] |= 8;
        assertEquals(
                List.of(0x77, 0x77, 0x77, 0x40),
                pixel(PictureDecoder.decode("a.tga", withAlpha).toRgba8(), 0));
    }

    private static List<Integer> pixel(Picture rgba, int x) {
        return List.of(rgba.sample(x, 0, 0), rgba.sample(x, 0, 1), rgba.sample(x, 0, 2), rgba.sample(x, 0, 3));
    }
}
