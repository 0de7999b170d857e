package nephele.engine.scene.light.bake;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.ShadowTest;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.Layer;
import nephele.engine.scene.light.bake.IndirectLight.SkyLight;
import nephele.engine.scene.light.bake.IndirectLightFile.Head;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** What is read is what was written, within the stated errors; bytes that were not written so are refused. */
@Execution(ExecutionMode.CONCURRENT)
class IndirectLightFileTest {
    private static final List<Brush> SOLIDS =
            List.of(ShadowTest.box(0, -0.5, 0, 2, 1, 2), ShadowTest.box(0, 0.5, 0, 1, 1, 1));
    private static final StaticShapes STATICS = StaticShapes.of(SOLIDS);
    private static final LightMapLayout LAYOUT = LightMapLayout.of(SOLIDS);
    private static final List<Integer> GROUNDS = List.of(12, 5);
    private static final Head HEAD = new Head("room.json", new byte[32]);
    private static final IndirectLight LIGHT = light(1);
    private static final byte[] BYTES = IndirectLightFile.encode(HEAD, LAYOUT, LIGHT);

    private static IndirectLight light(long seed) {
        var random = new SplittableRandom(seed);
        int texels = LAYOUT.width() * LAYOUT.height();
        return new IndirectLight(
                SkyLight.BAKED,
                List.of(layer("", Course.INDIRECT, texels, random), layer("lamps", Course.DIRECT, texels, random)));
    }

    private static Layer layer(String name, Course course, int texels, SplittableRandom random) {
        return new Layer(
                name,
                course,
                samples(texels, random),
                samples(0, random),
                GROUNDS.stream().map(points -> samples(points, random)).toList());
    }

    /** Makes light of 40 powers of ten, from all directions to one; every fourth point is black. */
    private static LightSamples samples(int points, SplittableRandom random) {
        LightSamples samples = LightSamples.black(points);
        for (int point = 0; point < points; point++) {
            double scale = point % 4 == 3 ? 0 : StrictMath.pow(10, random.nextDouble(-20, 20));
            for (int channel = 0; channel < 3; channel++) {
                samples.radiance()[3 * point + channel] = (float) (scale * random.nextDouble());
            }
            double luminance = luminance(samples, point) * random.nextDouble(0.25, 8);
            double length = random.nextDouble() / Math.sqrt(3);
            for (int axis = 0; axis < 3; axis++) {
                samples.moments()[4 * point + axis] = (float) (luminance * length * random.nextDouble(-1, 1));
            }
            samples.moments()[4 * point + 3] = (float) luminance;
        }
        return samples;
    }

    private static double luminance(LightSamples samples, int point) {
        float[] rgb = samples.radiance();
        return 0.2126 * rgb[3 * point] + 0.7152 * rgb[3 * point + 1] + 0.0722 * rgb[3 * point + 2];
    }

    private static Optional<IndirectLight> decoded(byte[] bytes) {
        return IndirectLightFile.decode(LAYOUT, STATICS, GROUNDS, bytes);
    }

    private static List<LightSamples> all(IndirectLight light) {
        return light.layers().stream()
                .flatMap(layer -> java.util.stream.Stream.concat(
                        java.util.stream.Stream.of(layer.texels(), layer.vertices()), layer.grounds().stream()))
                .toList();
    }

    @Test
    void whatIsReadIsWithinTheStatedErrors() {
        IndirectLight read = decoded(BYTES).orElseThrow();
        assertEquals(LIGHT.sky(), read.sky());
        assertEquals("lamps", read.layers().get(1).name());
        assertEquals(Course.DIRECT, read.layers().get(1).course());
        for (int i = 0; i < all(LIGHT).size(); i++) {
            LightSamples written = all(LIGHT).get(i);
            LightSamples again = all(read).get(i);
            for (int point = 0; point < written.points(); point++) {
                assertNear(written, again, point);
            }
        }
    }

    private static void assertNear(LightSamples written, LightSamples again, int point) {
        float[] rgb = Arrays.copyOfRange(written.radiance(), 3 * point, 3 * point + 3);
        float greatest = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
        for (int channel = 0; channel < 3; channel++) {
            assertEquals(rgb[channel], again.radiance()[3 * point + channel], 0.0034 * greatest);
        }
        float luminance = written.moments()[4 * point + 3];
        assertEquals(luminance, again.moments()[4 * point + 3], 0.026 * luminance);
        for (int axis = 0; axis < 3 && luminance > 0; axis++) {
            double d = written.moments()[4 * point + axis] / luminance;
            assertEquals(d, again.moments()[4 * point + axis] / again.moments()[4 * point + 3], 1 / 253.0);
        }
    }

    @Test
    void blackStaysBlack() {
        LightSamples read = all(decoded(BYTES).orElseThrow()).get(0);
        for (int point = 3; point < read.points(); point += 4) {
            assertArrayEquals(new float[3], Arrays.copyOfRange(read.radiance(), 3 * point, 3 * point + 3));
            assertArrayEquals(new float[4], Arrays.copyOfRange(read.moments(), 4 * point, 4 * point + 4));
        }
    }

    @Test
    void whatIsNoLightIsBlack() {
        LightSamples odd = new LightSamples(
                new float[] {Float.NaN, 1, 1, -1, -2, -3, Float.MIN_VALUE, 0, 0, 2, -1, 1},
                new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, Float.NaN, 3, 0, 1});
        var empty = LightMapLayout.of(List.of());
        var layer = new Layer(
                "",
                Course.INDIRECT,
                LightSamples.black(empty.width() * empty.height()),
                samples(0, null),
                List.of(odd));
        byte[] bytes = IndirectLightFile.encode(HEAD, empty, new IndirectLight(SkyLight.LIVE, List.of(layer)));
        LightSamples read = IndirectLightFile.decode(empty, StaticShapes.of(List.of()), List.of(4), bytes)
                .orElseThrow()
                .layers()
                .get(0)
                .grounds()
                .get(0);
        assertArrayEquals(new float[9], Arrays.copyOf(read.radiance(), 9));
        assertArrayEquals(new float[12], Arrays.copyOf(read.moments(), 12));
        assertArrayEquals(new float[] {2, 0, 1}, Arrays.copyOfRange(read.radiance(), 9, 12), 0.01f);
        assertArrayEquals(new float[] {0, 1, 0, 1}, Arrays.copyOfRange(read.moments(), 12, 16), 0.03f);
    }

    @Test
    void whatWasReadIsWrittenAsTheSameBytes() {
        assertArrayEquals(BYTES, IndirectLightFile.encode(HEAD, LAYOUT, light(1)));
        assertArrayEquals(
                BYTES, IndirectLightFile.encode(HEAD, LAYOUT, decoded(BYTES).orElseThrow()));
        assertFalse(Arrays.equals(BYTES, IndirectLightFile.encode(HEAD, LAYOUT, light(2))));
    }

    @Test
    void theHeadIsReadFromTheStartOfAFile() {
        Head head = IndirectLightFile.head(Arrays.copyOf(BYTES, 1024)).orElseThrow();
        assertEquals("room.json", head.levelFile());
        assertArrayEquals(new byte[32], head.content());
    }

    @Test
    void noPartOfAFileIsAFile() {
        for (int length = 0; length < BYTES.length; length += length < 200 ? 1 : 37) {
            assertTrue(decoded(Arrays.copyOf(BYTES, length)).isEmpty());
        }
        assertTrue(decoded(Arrays.copyOf(BYTES, BYTES.length + 1)).isEmpty());
    }

    @Test
    void aFlippedBitIsNoticedAnywhere() {
        var random = new SplittableRandom(3);
        for (int i = 0; i < 2_000; i++) {
            byte[] damaged = BYTES.clone();
            damaged[i < 200 ? i : random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
            assertTrue(decoded(damaged).isEmpty());
        }
    }

    /** A file that someone made, with a sum that is right, can be refused by what it says alone. */
    @Test
    void aForgedFileIsRefusedOrReadInItsBounds() {
        var random = new SplittableRandom(4);
        int read = 0;
        for (int i = 0; i < 2_000; i++) {
            byte[] forged = BYTES.clone();
            for (int k = 0; k < 3; k++) {
                forged[random.nextInt(12, i % 2 == 0 ? 120 : forged.length)] = (byte) random.nextInt();
            }
            read += decoded(resealed(forged)).isPresent() ? 1 : 0;
        }
        assertTrue(read < 2_000, "most are refused");
        byte[] huge = BYTES.clone();
        int layers = new String(BYTES, java.nio.charset.StandardCharsets.ISO_8859_1).indexOf("BAKED") + 5;
        ByteBuffer.wrap(huge).putInt(layers, Integer.MAX_VALUE);
        assertTrue(decoded(resealed(huge)).isEmpty());
    }

    private static byte[] resealed(byte[] bytes) {
        CRC32 crc = new CRC32();
        crc.update(bytes, 12, bytes.length - 12);
        ByteBuffer.wrap(bytes).putInt(8, (int) crc.getValue());
        return bytes;
    }

    @Test
    void lightOfOtherShapesIsRefused() {
        List<Brush> others = List.of(SOLIDS.get(0), ShadowTest.box(0, 0.5, 0, 1, 1, 0.5));
        assertTrue(IndirectLightFile.decode(LightMapLayout.of(others), StaticShapes.of(others), GROUNDS, BYTES)
                .isEmpty());
        assertTrue(IndirectLightFile.decode(LAYOUT, STATICS, List.of(12), BYTES).isEmpty());
        assertTrue(
                IndirectLightFile.decode(LAYOUT, STATICS, List.of(12, 6), BYTES).isEmpty());
        assertTrue(IndirectLightFile.decode(LAYOUT, STATICS, List.of(12, 1 << 20), BYTES)
                .isEmpty());
    }

    /** Smooth light shrinks: that of the campaign is to fit into 16 MB. */
    @Test
    void smoothLightTakesLessThanFiveBytesAPoint() {
        var random = new SplittableRandom(5);
        int points = LAYOUT.width() * LAYOUT.height();
        LightSamples smooth = LightSamples.black(points);
        for (int i = 0; i < points; i++) {
            double noise = 1 + 0.02 * random.nextGaussian();
            double light = (2 + StrictMath.sin(0.02 * i)) * noise;
            smooth.radiance()[3 * i] = (float) light;
            smooth.radiance()[3 * i + 1] = (float) (light * (0.8 + 0.002 * random.nextGaussian()));
            smooth.radiance()[3 * i + 2] = (float) (light * (0.6 + 0.002 * random.nextGaussian()));
            smooth.moments()[4 * i + 1] = (float) (light * (0.3 + 0.01 * random.nextGaussian()));
            smooth.moments()[4 * i + 3] = (float) (light * 0.5);
        }
        var layer = new Layer(
                "",
                Course.INDIRECT,
                smooth,
                samples(0, random),
                List.of(LightSamples.black(12), LightSamples.black(5)));
        int bytes = IndirectLightFile.encode(HEAD, LAYOUT, new IndirectLight(SkyLight.LIVE, List.of(layer))).length;
        assertTrue(bytes < 5 * points + 200, bytes + " bytes for " + points + " points");
    }
}
