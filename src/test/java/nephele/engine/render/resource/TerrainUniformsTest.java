package nephele.engine.render.resource;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The arithmetic of terrain-position.glsl in floats places vertices near the eye as doubles do. */
class TerrainUniformsTest {
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.123456789, 3.3, 17.77, 1000.1})
    void verticesNearTheEyeAreExact(double cell) {
        SplittableRandom random = new SplittableRandom(3);
        float high = TerrainUniforms.high(cell);
        float low = (float) (cell - high);
        for (int i = 0; i < 10_000; i++) {
            int column = random.nextInt(8193);
            double eye = column * cell + random.nextDouble(-30, 30);
            float eyeHigh = (float) eye;
            float eyeLow = (float) (eye - eyeHigh);
            float relative = (column * high - eyeHigh) + (column * low - eyeLow);
            assertEquals(column * cell - eye, relative, 1e-5 + 1e-10 * eye, "column " + column);
        }
    }
}
