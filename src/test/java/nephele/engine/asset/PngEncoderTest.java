package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PngEncoderTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aPictureReadsBackAsTheSameSamples(int channels) {
        byte[] samples = new byte[7 * 3 * channels];
        new Random(channels).nextBytes(samples);
        Picture read = PictureDecoder.decode("a.png", PngEncoder.file(new Picture(7, 3, channels, 8, samples)));
        assertEquals(7, read.width());
        assertEquals(channels, read.channels());
        assertArrayEquals(samples, read.samples());
        Picture deep = new Picture(7, 3, channels, 16, new byte[2 * samples.length]);
        assertThrows(IllegalArgumentException.class, () -> PngEncoder.file(deep));
    }
}
