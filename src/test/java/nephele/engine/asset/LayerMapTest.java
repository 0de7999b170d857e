package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

@Execution(ExecutionMode.CONCURRENT)
class LayerMapTest {
    @Test
    void aMapReadsBackAsTheSameTexelsAndEqualMapsHaveEqualFiles() {
        byte[] texels = new byte[2 * 5 * 3];
        new Random(7).nextBytes(texels);
        LayerMap map = new LayerMap(5, 3, texels);
        byte[] file = map.png();
        LayerMap read = LayerMap.read("a.png", file);
        assertArrayEquals(texels, read.texels());
        assertEquals(5, read.columns());
        assertEquals(texels[2 * (2 * 5 + 4)] & 0xff, read.layer(4, 2));
        assertEquals(texels[2 * (2 * 5 + 4) + 1] & 0xff, read.weight(4, 2));
        assertArrayEquals(file, read.png());
    }

    static Stream<Arguments> wrong() {
        byte[] good = LayerMap.blank(4, 4).png();
        return Stream.of(
                Arguments.of("is no picture", new byte[40]),
                Arguments.of("is a BMP picture", new byte[] {'B', 'M', 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}),
                Arguments.of("is damaged", Arrays.copyOf(good, good.length - 20)),
                Arguments.of("has 1 x 4 pixels", LayerMap.blank(1, 4).png()),
                Arguments.of("claims 8194 x 2 pixels", LayerMap.blank(8194, 2).png()),
                Arguments.of("has 1 channels of 16 bits", new HeightMap(2, 2, 16, new short[] {1, 2, 3, 4}).png()),
                Arguments.of(
                        "has 4 channels of 8 bits",
                        new TestAssets()
                                .seeThroughPicture("a.png", 4, 4, (x, y) -> 0x80000000)
                                .bytes("a.png")));
    }

    @ParameterizedTest
    @MethodSource("wrong")
    void otherFilesAreRefusedWithARemedy(String reason, byte[] bytes) {
        AssetException told = assertThrows(AssetException.class, () -> LayerMap.read("a.png", bytes));
        assertTrue(told.reason().startsWith(reason), told::getMessage);
        assertEquals("a.png", told.assetId());
    }
}
