package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class PictureDecoderTest {
    private static String refusal(String id, byte[] bytes) {
        return assertThrows(AssetException.class, () -> PictureDecoder.decode(id, bytes))
                .getMessage();
    }

    /** The PNG reader and its twin agree on every sample. */
    @ParameterizedTest
    @CsvSource({"8,0", "16,0", "8,2", "16,2", "8,4", "16,4", "8,6", "16,6"})
    void bothPngReadersAgree(int bitDepth, int colour) throws Exception {
        for (int side = 1; side <= 23; side += 2) {
            byte[] file = SamplePictures.png(side, 24 - side, bitDepth, colour, side);
            PngFile png = PngFile.of(file);
            Picture quick = PngPixels.decode(png);
            Picture twin = ImageIoPictures.decode(PictureFormat.PNG, file);
            assertEquals(bitDepth, quick.bitsPerChannel());
            assertEquals(twin.channels(), quick.channels());
            assertArrayEquals(twin.samples(), quick.samples());
        }
    }

    @Test
    void sixteenBitGreyKeepsItsSixteenBits() {
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_USHORT_GRAY);
        image.getRaster().setPixels(0, 0, 3, 1, new int[] {0, 0x1234, 0xffff});
        Picture picture = PictureDecoder.decode("height.png", SamplePictures.written(image, "png"));
        assertEquals(16, picture.bitsPerChannel());
        assertEquals(1, picture.channels());
        assertEquals(0x1234, picture.sample(1, 0, 0));
        assertEquals(0xffff, picture.sample(2, 0, 0));
        assertEquals(0x12, picture.toRgba8().sample(1, 0, 2));
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp", "jpg"})
    void whatImageIoWritesIsRead(String format) {
        BufferedImage image = new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 128; i++) {
            image.setRGB(i % 16, i / 16, 0x204060);
        }
        Picture picture = PictureDecoder.decode("x." + format, SamplePictures.written(image, format));
        assertEquals(3, picture.channels());
        assertEquals(0x20, picture.sample(15, 7, 0), 2);
        assertEquals(0x40, picture.sample(3, 2, 1), 2);
        assertEquals(0x60, picture.sample(0, 0, 2), 2);
    }

    @Test
    void palettesAndInterlacedFilesAreRead() {
        BufferedImage image = new BufferedImage(5, 5, BufferedImage.TYPE_BYTE_INDEXED);
        image.setRGB(2, 2, 0xffff0000);
        Picture palette = PictureDecoder.decode("p.png", SamplePictures.written(image, "png"));
        assertEquals(255, palette.sample(2, 2, 0));
        byte[] row = SamplePictures.deflated(new byte[] {0, 77});
        byte[] interlaced = SamplePictures.png(SamplePictures.header(1, 1, 8, 0, 1), SamplePictures.chunk("IDAT", row));
        assertEquals(77, PictureDecoder.decode("i.png", interlaced).sample(0, 0, 0));
    }

    /** The transparent entry of a palette and the transparent grey are kept. */
    @Test
    void transparencyIsKept() {
        byte[] pixels = SamplePictures.chunk("IDAT", SamplePictures.deflated(new byte[] {0, 1, 0}));
        byte[] palette = SamplePictures.chunk("PLTE", new byte[] {9, 8, 7, 6, 5, 4});
        byte[] clear = SamplePictures.chunk("tRNS", new byte[] {0});
        byte[] header = SamplePictures.header(2, 1, 8, 3, 0);
        Picture indexed = PictureDecoder.decode("p.png", SamplePictures.png(header, palette, clear, pixels));
        assertArrayEquals(new byte[] {6, 5, 4, -1, 9, 8, 7, 0}, indexed.samples());
        byte[] clearGrey = SamplePictures.chunk("tRNS", new byte[] {0, 1});
        byte[] greyHeader = SamplePictures.header(2, 1, 8, 0, 0);
        Picture grey = PictureDecoder.decode("g.png", SamplePictures.png(greyHeader, clearGrey, pixels))
                .toRgba8();
        assertEquals(0, grey.sample(0, 0, 3));
        assertEquals(255, grey.sample(1, 0, 3));
    }

    /** TGA with 24 and 32 bits, with 16 bits as 5-5-5, and with run lengths is read. */
    @Test
    void tgaVariantsAreRead() {
        byte[] bgr = {3, 2, 1, 6, 5, 4};
        Picture plain = PictureDecoder.decode("a.tga", SamplePictures.tga(2, 2, 1, 24, bgr));
        assertArrayEquals(new byte[] {1, 2, 3, 4, 5, 6}, plain.samples());
        byte[] run = {(byte) 0x81, 3, 2, 1, 9};
        Picture packed = PictureDecoder.decode("a.tga", SamplePictures.tga(10, 2, 1, 32, run));
        assertArrayEquals(new byte[] {1, 2, 3, 9, 1, 2, 3, 9}, packed.samples());
        byte[] red555 = {0x00, 0x7c};
        Picture small = PictureDecoder.decode("a.tga", SamplePictures.tga(2, 1, 1, 16, red555));
        assertEquals(255, small.toRgba8().sample(0, 0, 0));
        assertEquals(0, small.toRgba8().sample(0, 0, 1));
    }

    @Test
    void aPaletteOfATgaIsReadUpToItsLastColour() {
        byte[] rgb = {3, 2, 1, 6, 5, 4, 6, 5, 4, 3, 2, 1};
        for (byte[] file : List.of(
                SamplePictures.paletteTga(1, new byte[] {0, 1, 1, 0}),
                SamplePictures.paletteTga(9, new byte[] {0, 0, (byte) 0x81, 1, 0, 0}))) {
            assertArrayEquals(rgb, PictureDecoder.decode("a.tga", file).samples());
        }
    }

    /** Packets may cross rows; packets beyond the picture are rejected. */
    @Test
    void packetsOfATgaMayCrossItsRows() {
        byte[] packets = {(byte) 0x82, 1, 2, 3, 0, 4, 5, 6};
        Picture picture = PictureDecoder.decode("a.tga", SamplePictures.tga(10, 2, 2, 24, packets));
        assertArrayEquals(new byte[] {3, 2, 1, 3, 2, 1, 3, 2, 1, 6, 5, 4}, picture.samples());
    }

    @Test
    void claimsOfHugePicturesAreRefusedByTheirHeader() {
        byte[] bomb = SamplePictures.png(SamplePictures.header(100_000, 100_000, 8, 6, 0));
        assertTrue(refusal("bomb.png", bomb).contains("claims 100000 x 100000 pixels"));
        byte[] thin = SamplePictures.png(SamplePictures.header(4096, 4096, 8, 6, 0));
        assertTrue(refusal("thin.png", thin).contains("pixels in " + thin.length + " bytes"));
        assertTrue(refusal("zero.png", SamplePictures.png(SamplePictures.header(0, 9, 8, 6, 0)))
                .contains("has no pixels"));
        assertTrue(refusal("big.tga", SamplePictures.tga(2, 65535, 65535, 32, new byte[4]))
                .contains("claims"));
        assertTrue(refusal("text.png", "not a picture at all".getBytes()).contains("is not a picture"));
    }

    @Test
    void aSecondHeaderChangesNothing() {
        byte[] second = SamplePictures.png(
                SamplePictures.header(1, 1, 8, 0, 0),
                SamplePictures.header(8000, 8000, 8, 0, 0),
                SamplePictures.chunk("IDAT", SamplePictures.deflated(new byte[] {0, 77})));
        assertTrue(refusal("two.png", second).contains("damaged"));
    }

    /** A text chunk that would expand to 64 MiB is not expanded by either reader. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void compressedTextIsNotUnpacked(int interlace) {
        byte[] text = SamplePictures.deflated(new byte[64 << 20]);
        byte[] content = new byte[text.length + 3];
        content[0] = 'k';
        System.arraycopy(text, 0, content, 3, text.length);
        byte[] file = SamplePictures.png(
                SamplePictures.header(1, 1, 8, 0, interlace),
                SamplePictures.chunk("zTXt", content),
                SamplePictures.chunk("iCCP", content),
                SamplePictures.chunk("IDAT", SamplePictures.deflated(new byte[] {0, 77})));
        long before = allocatedBytes();
        assertEquals(77, PictureDecoder.decode("ztxt.png", file).sample(0, 0, 0));
        assertTrue(allocatedBytes() - before < 8 << 20, "allocated " + (allocatedBytes() - before));
    }

    private static long allocatedBytes() {
        var threads = (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
        return threads.getCurrentThreadAllocatedBytes();
    }

    /** Every truncation and every bit flip decodes or is rejected with the asset's name; no other exception escapes. */
    @ParameterizedTest
    @CsvSource({"8,6,png", "16,0,png", "4,3,png", "24,0,tga", "32,0,bmp", "8,0,jpg"})
    void damagedFilesDecodeOrAreRefused(int bits, int colour, String format) {
        byte[] file = sample(bits, colour, format);
        for (int length = 0; length < file.length; length++) {
            attempt("cut." + format, Arrays.copyOf(file, length));
        }
        for (int i = 0; i < file.length; i++) {
            byte[] flipped = file.clone();
            flipped[i] ^= (byte) (1 << i % 8);
            attempt("flip." + format, flipped);
        }
    }

    private static byte[] sample(int bits, int colour, String format) {
        if (format.equals("png") && colour != 3) {
            return SamplePictures.png(7, 9, bits, colour, 1);
        }
        if (format.equals("tga")) {
            byte[] content = new byte[6 * 5 * 3];
            new Random(1).nextBytes(content);
            return SamplePictures.tga(10, 6, 5, bits, content);
        }
        int type = colour == 3 ? BufferedImage.TYPE_BYTE_BINARY : BufferedImage.TYPE_INT_RGB;
        return SamplePictures.written(new BufferedImage(9, 7, type), format);
    }

    private static void attempt(String id, byte[] bytes) {
        try {
            Picture picture = PictureDecoder.decode(id, bytes);
            assertTrue(picture.samples().length <= 64 << 20);
        } catch (AssetException refused) {
            assertEquals(id, refused.assetId());
            assertTrue(refused.getMessage().startsWith(id + ": "));
        }
    }
}
