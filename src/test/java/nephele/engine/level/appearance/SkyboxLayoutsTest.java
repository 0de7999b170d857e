package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntBinaryOperator;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.SamplePictures;
import nephele.engine.asset.TestAssets;
import nephele.engine.asset.TgaSample;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A smooth function of the direction, written into the pictures of each layout by the layout's own convention, is seen
 * again in every direction, also across all edges and at all corners.
 */
@Execution(ExecutionMode.CONCURRENT)
class SkyboxLayoutsTest {
    private static final int SIDE = 64;
    private static final double STEP = 1e-9;

    @ParameterizedTest
    @EnumSource
    void theFunctionIsSeenAcrossAllEdges(SkyboxLayout layout) {
        SkyRadiance sky = sky(layout, SkyboxConvention.assets(layout, SIDE), SkyboxConvention.names(layout, "png"));
        for (int edge = 0; edge < 12; edge++) {
            for (int i = 0; i <= 200; i++) {
                double along = i / 100.0 - 1;
                for (double first : new double[] {0.5, 0.9, 0.97, 0.99, 1.01, 1.03, 1.1, 2}) {
                    assertSeen(sky, onEdge(edge, along, first), 5e-3);
                }
                assertSame(sky, onEdge(edge, along, 1 - STEP), onEdge(edge, along, 1 + STEP));
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void theThreeFacesOfACornerMeetInOneColour(SkyboxLayout layout) {
        SkyRadiance sky = sky(layout, SkyboxConvention.assets(layout, SIDE), SkyboxConvention.names(layout, "png"));
        for (int corner = 0; corner < 8; corner++) {
            Vector3d middle = new Vector3d(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1);
            assertSeen(sky, middle, 5e-3);
            for (int axis = 0; axis < 3; axis++) {
                Vector3d onFace = new Vector3d(middle);
                onFace.setComponent(axis, onFace.get(axis) * (1 + STEP));
                assertSame(sky, middle, onFace);
            }
        }
    }

    /** A layout other than the written one shows something else, so the tests above can tell layouts apart. */
    @Test
    void noTwoLayoutsAreTheSame() {
        List<SkyboxLayout> layouts =
                List.of(SkyboxLayout.FACES, SkyboxLayout.OPENGL, SkyboxLayout.QUAKE2, SkyboxLayout.TERRAGEN);
        for (SkyboxLayout written : layouts) {
            for (SkyboxLayout read : layouts) {
                SkyRadiance sky =
                        sky(read, SkyboxConvention.assets(written, 8), SkyboxConvention.names(written, "png"));
                double most = 0;
                for (int i = 0; i < 100; i++) {
                    Vector3d d = new Vector3d(i % 5 - 1.9, i % 7 - 2.9, i % 3 - 1.1).normalize();
                    most = Math.max(most, seen(sky, d).distance(SkyboxConvention.colour(d)));
                }
                assertEquals(written == read, most < 0.05, written + " read as " + read + ": " + most);
            }
        }
    }

    /** The advice in docs/skyboxes.md for sets that OpenGL shows mirrored. */
    @Test
    void facesWithTheLastTwoExchangedMirrorOpengl() {
        TestAssets assets = SkyboxConvention.assets(SkyboxLayout.OPENGL, SIDE);
        List<String> names = new ArrayList<>(SkyboxConvention.names(SkyboxLayout.OPENGL, "png"));
        names.add(4, names.remove(5));
        SkyRadiance sky = sky(SkyboxLayout.FACES, assets, names);
        for (int i = 0; i < 100; i++) {
            Vector3d d = new Vector3d(i % 5 - 1.9, i % 7 - 2.9, i % 3 - 1.1);
            Vector3d expected = SkyboxConvention.colour(new Vector3d(d.x, d.y, -d.z));
            assertEquals(0, seen(sky, d).distance(expected), 5e-3);
        }
    }

    /** Returns every kind of picture file that a skybox can have. */
    static List<Kind> kinds() {
        List<Kind> kinds = new ArrayList<>();
        for (int bits : new int[] {16, 24, 32}) {
            for (TgaSample.Packing packing : TgaSample.Packing.values()) {
                for (TgaSample.Origin origin : TgaSample.Origin.values()) {
                    TgaSample tga = new TgaSample(bits, packing, origin);
                    kinds.add(new Kind("tga", tga.toString(), rgb -> tga.written(SIDE, SIDE, rgb)));
                }
            }
        }
        for (String format : List.of("png", "jpg", "bmp")) {
            kinds.add(new Kind(format, format, rgb -> {
                BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
                for (int i = 0; i < SIDE * SIDE; i++) {
                    image.setRGB(i % SIDE, i / SIDE, rgb.applyAsInt(i % SIDE, i / SIDE));
                }
                return SamplePictures.written(image, format);
            }));
        }
        return kinds;
    }

    /** Writes a picture to the bytes of a file. */
    @FunctionalInterface
    private interface FileWriter {
        byte[] written(IntBinaryOperator rgbAt);
    }

    /** A kind of picture file. */
    record Kind(String extension, String name, FileWriter writer) {
        TestAssets assets(SkyboxLayout layout) {
            TestAssets assets = new TestAssets();
            List<String> names = SkyboxConvention.names(layout, extension);
            for (int i = 0; i < names.size(); i++) {
                assets.file(names.get(i), writer.written(SkyboxConvention.square(layout, i, SIDE)));
            }
            return assets;
        }

        @Override
        public String toString() {
            return name;
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void everyKindOfFileShowsTheFunction(Kind kind) {
        SkyboxLayout layout = SkyboxLayout.QUAKE2;
        SkyRadiance sky = sky(layout, kind.assets(layout), SkyboxConvention.names(layout, kind.extension()));
        boolean isExact = !kind.name().contains("bits=16") && !kind.extension().equals("jpg");
        double tolerance = isExact ? 5e-3 : 0.03;
        for (int edge = 0; edge < 12; edge++) {
            for (int i = 0; i <= 40; i++) {
                for (double first : new double[] {0.2, 0.6, 0.99, 1.01, 1.5}) {
                    assertSeen(sky, onEdge(edge, i / 20.0 - 1, first), tolerance);
                }
            }
        }
    }

    /** A file that was cut anywhere is refused by its name. */
    @ParameterizedTest
    @MethodSource("kinds")
    void aCutFileIsNamed(Kind kind) {
        SkyboxLayout layout = SkyboxLayout.TERRAGEN;
        List<String> names = SkyboxConvention.names(layout, kind.extension());
        TestAssets assets = kind.assets(layout);
        byte[] whole = assets.bytes(names.get(4));
        for (int length : new int[] {0, 1, 10, 17, 18, 19, 30, whole.length / 2, whole.length - 13, whole.length - 1}) {
            if (kind.extension().equals("png") && length > whole.length - 13) {
                continue; // Only the end chunk is incomplete.
            }
            assets.file(names.get(4), Arrays.copyOf(whole, length));
            AssetException refused =
                    assertThrows(AssetException.class, () -> sky(layout, assets, names), kind + " cut to " + length);
            assertTrue(refused.getMessage().startsWith(names.get(4) + ": "), refused.getMessage());
        }
    }

    @Test
    void aSquareOfAnotherSizeIsNamed() {
        TestAssets assets =
                SkyboxConvention.assets(SkyboxLayout.QUAKE2, 8).picture("box3.png", 16, 16, (x, y) -> 0x808080);
        List<String> names = SkyboxConvention.names(SkyboxLayout.QUAKE2, "png");
        String message = assertThrows(AssetException.class, () -> sky(SkyboxLayout.QUAKE2, assets, names))
                .getMessage();
        assertTrue(message.startsWith("box3.png: is 16 x 16 pixels"), message);
    }

    private static SkyRadiance sky(SkyboxLayout layout, TestAssets assets, List<String> names) {
        return SkyRadiance.of(
                        new Sky.Skybox(layout, names),
                        id -> PictureDecoder.decode(id, assets.bytes(id)),
                        ColourDecoding.AS_STORED)
                .orElseThrow();
    }

    private static Vector3d onEdge(int edge, double along, double first) {
        double[] v = new double[3];
        int free = edge / 4;
        v[free] = along;
        v[(free + 1) % 3] = (edge & 1) == 0 ? first : -first;
        v[(free + 2) % 3] = (edge & 2) == 0 ? 1 : -1;
        return new Vector3d(v[0], v[1], v[2]);
    }

    private static void assertSeen(SkyRadiance sky, Vector3d direction, double tolerance) {
        Vector3d expected = SkyboxConvention.colour(direction);
        Vector3d seen = seen(sky, direction);
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.get(c), seen.get(c), tolerance, "channel " + c + " towards " + direction);
        }
    }

    private static void assertSame(SkyRadiance sky, Vector3d here, Vector3d there) {
        assertEquals(0, seen(sky, here).distance(seen(sky, there)), 1e-6, () -> "a step at " + here);
    }

    private static Vector3d seen(SkyRadiance sky, Vector3d direction) {
        Vector3d unit = new Vector3d(direction).normalize();
        return sky.from(unit.x, unit.y, unit.z);
    }
}
