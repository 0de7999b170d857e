package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntBinaryOperator;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class HeightMapTest {
    private static final int[] VALUES = {0, 1, 255, 256, 32768, 65535};

    private static byte[] picture(String format, int type, int columns, int rows, int... values) throws IOException {
        BufferedImage image = new BufferedImage(columns, rows, type);
        for (int i = 0; i < values.length; i++) {
            int bands = image.getRaster().getNumBands();
            for (int band = 0; band < bands; band++) {
                image.getRaster().setSample(i % columns, i / columns, band, values[i]);
            }
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        assertTrue(ImageIO.write(image, format, bytes));
        return bytes.toByteArray();
    }

    private static byte[] png(int type, int columns, int rows, int... values) throws IOException {
        return picture("png", type, columns, rows, values);
    }

    private static byte[] raw(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        Arrays.stream(values).forEach(value -> bytes.putShort((short) value));
        return bytes.array();
    }

    /** Returns an uncompressed TGA of 8-bit grey whose first row is the upper one. */
    private static byte[] tga(int columns, int rows, int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(18 + values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(2, (byte) 3).putShort(12, (short) columns).putShort(14, (short) rows);
        bytes.put(16, (byte) 8).put(17, (byte) 0x20).position(18);
        Arrays.stream(values).forEach(value -> bytes.put((byte) value));
        return bytes.array();
    }

    private static int[] values(HeightMap map) {
        int[] values = new int[map.columns() * map.rows()];
        Arrays.setAll(values, i -> map.value(i % map.columns(), i / map.columns()));
        return values;
    }

    @Test
    void allSixteenBitsOfAPngAreKept() throws IOException {
        HeightMap map = HeightMap.read("a.png", png(BufferedImage.TYPE_USHORT_GRAY, 3, 2, VALUES));
        assertEquals(16, map.bits());
        assertArrayEquals(VALUES, values(map));
    }

    @Test
    void rawHeightsHaveTheirLowByteFirst() {
        int[] square = {0, 1, 256, 65535};
        assertArrayEquals(square, values(HeightMap.read("a.r16", raw(square))));
        assertEquals(2, HeightMap.read("A.R16", raw(square)).rows());
    }

    static Stream<Arguments> ofEightBits() throws IOException {
        int[] values = {0, 1, 128, 255};
        return Stream.of(
                Arguments.of("a.png", png(BufferedImage.TYPE_BYTE_GRAY, 2, 2, values)),
                Arguments.of("b.png", png(BufferedImage.TYPE_3BYTE_BGR, 2, 2, values)),
                Arguments.of("c.png", png(BufferedImage.TYPE_4BYTE_ABGR, 2, 2, values)),
                Arguments.of("a.bmp", picture("bmp", BufferedImage.TYPE_BYTE_GRAY, 2, 2, values)),
                Arguments.of("b.bmp", picture("bmp", BufferedImage.TYPE_3BYTE_BGR, 2, 2, values)),
                Arguments.of("a.tga", tga(2, 2, values)));
    }

    @ParameterizedTest
    @MethodSource("ofEightBits")
    void eightBitsFillTheSameRange(String name, byte[] bytes) {
        HeightMap map = HeightMap.read(name, bytes);
        assertEquals(8, map.bits());
        assertArrayEquals(new int[] {0, 257, 128 * 257, 65535}, values(map));
    }

    @Test
    void aColouredPictureCountsByItsMean() throws IOException {
        BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(1, 1, 0xff0000);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        assertEquals(65535 / 3, HeightMap.read("a.png", bytes.toByteArray()).value(1, 1));
    }

    private static byte[] claiming(byte[] png, int columns, int rows) {
        ByteBuffer bytes = ByteBuffer.wrap(png.clone());
        bytes.putInt(16, columns).putInt(20, rows);
        java.util.zip.CRC32 sum = new java.util.zip.CRC32();
        sum.update(bytes.array(), 12, 17);
        bytes.putInt(29, (int) sum.getValue());
        return bytes.array();
    }

    static Stream<Arguments> bad() throws IOException {
        byte[] good = png(BufferedImage.TYPE_USHORT_GRAY, 3, 2, VALUES);
        return Stream.of(
                Arguments.of("a.png", png(BufferedImage.TYPE_BYTE_GRAY, 1, 1, 7), "has 1 x 1 samples", "2 to 8193"),
                Arguments.of("a.png", png(BufferedImage.TYPE_BYTE_GRAY, 5, 1, 7), "has 5 x 1 samples", "scale it"),
                Arguments.of("a.png", claiming(good, 20_000, 20_000), "has 20000 x 20000 samples", "scale it"),
                Arguments.of("a.png", claiming(good, -1, 2), "has 4294967295 x 2 samples", "scale it"),
                Arguments.of("a.png", claiming(good, 8193, 8193), "claims 67125249 pixels", "copy the file again"),
                Arguments.of("a.png", Arrays.copyOf(good, good.length - 20), "is damaged", "save it again"),
                Arguments.of("a.png", Arrays.copyOf(good, 20), "is cut off", "copy the file again"),
                Arguments.of("a.png", new byte[0], "is no height map", "16 bits"),
                Arguments.of("a.png", picture("jpg", BufferedImage.TYPE_BYTE_GRAY, 2, 2, 7), "is a JPEG", "PNG"),
                Arguments.of("a.r16", good, "is a PNG picture", "rename it to .png"),
                Arguments.of("a.r16", new byte[0], "has 0 x 0 samples", "scale it"),
                Arguments.of("a.r16", new byte[2], "has 1 x 1 samples", "scale it"),
                Arguments.of("a.r16", new byte[9], "has 9 bytes", "16-bit heights"),
                Arguments.of("a.r16", new byte[16], "8-bit heights of 4 x 4", "16-bit heights"),
                Arguments.of("a.r16", new byte[12], "has 12 bytes", "low byte first"),
                Arguments.of("a.tga", tga(1, 2, 1, 2), "has 1 x 2 samples", "scale it"),
                Arguments.of("a.tga", Arrays.copyOf(tga(2, 2, 1, 2, 3, 4), 20), "is damaged", "save it again"));
    }

    @ParameterizedTest
    @MethodSource("bad")
    void aBadMapIsRefusedWithItsNameTheReasonAndARemedy(String name, byte[] bytes, String reason, String remedy) {
        AssetException told = assertThrows(AssetException.class, () -> HeightMap.read(name, bytes));
        assertTrue(
                told.getMessage().startsWith(name + ": " + reason)
                        || told.getMessage().contains(reason),
                told.getMessage());
        assertTrue(told.remedy().contains(remedy), told.getMessage());
    }

    private static HeightMap swapped(HeightMap map) {
        short[] values = map.values().clone();
        for (int i = 0; i < values.length; i++) {
            values[i] = Short.reverseBytes(values[i]);
        }
        return new HeightMap(map.columns(), map.rows(), map.bits(), values);
    }

    /** No map that comes with the game seems to have exchanged bytes, and each does once it has. */
    @ParameterizedTest
    @ValueSource(strings = {"bench", "hills", "stones"})
    void exchangedBytesOfShippedMapsAreTold(String name) {
        String id = "terrain/" + name + ".png";
        HeightMap map = HeightMap.read(id, new ResourceAssets("/assets").bytes(id));
        assertEquals(16, map.bits());
        assertFalse(map.seemsSwapped());
        assertTrue(swapped(map).seemsSwapped());
    }

    /** Maps that are rough either way, or of few bits, are no proof. */
    @Test
    void roughMapsDoNotSeemSwapped() {
        var random = new SplittableRandom(4);
        List<IntBinaryOperator> all = List.of(
                (x, y) -> random.nextInt(65_536),
                (x, y) -> 256 * (x + y),
                (x, y) -> 257 * (x + y),
                (x, y) -> 64 * (x + y),
                (x, y) -> 7,
                (x, y) -> 300 * y,
                (x, y) -> x < 16 ? 0 : 65_535,
                (x, y) -> 20_000 + x * x + random.nextInt(200));
        for (IntBinaryOperator heights : all) {
            short[] values = new short[32 * 32];
            for (int i = 0; i < values.length; i++) {
                values[i] = (short) heights.applyAsInt(i % 32, i / 32);
            }
            assertFalse(new HeightMap(32, 32, 16, values).seemsSwapped(), "map " + all.indexOf(heights));
        }
    }
}
