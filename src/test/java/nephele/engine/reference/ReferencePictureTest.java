package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import nephele.engine.level.Body;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** A picture is a value of level, eye, size, samples and seed. */
class ReferencePictureTest {
    private static final Pinhole EYE = Stage.eye(new Vec3(1, 2, 4), Vec3.ZERO, 0.7);

    private static Stage stage() {
        return new Stage()
                .sky(new Sky.Gradient(new Vec3(0.1, 0.2, 0.9), Stage.grey(0.7), Stage.grey(0.2)))
                .lambert("m", Stage.grey(0.5))
                .box("m", new Vec3(0, -0.5, 0), new Vec3(6, 1, 6))
                .box("m", new Vec3(0, 0.5, 0), Stage.grey(1));
    }

    private static float[] picture(int samples, long seed, int threads) {
        return stage().picture(EYE, new TraceSettings(24, 18, samples, seed, threads));
    }

    @Test
    void threadsDoNotChangeIt() {
        float[] one = picture(5, 7, 1);
        assertArrayEquals(one, picture(5, 7, 2));
        assertArrayEquals(one, picture(5, 7, 3));
    }

    @Test
    void aSeedChangesTheNoiseAndNotTheMean() {
        float[] first = picture(64, 1, 2);
        float[] second = picture(64, 2, 2);
        assertFalse(Arrays.equals(first, second));
        assertEquals(mean(first), mean(second), 2e-3);
        assertEquals(mean(picture(1024, 3, 2)), mean(first), 2e-3);
    }

    /** One number for all that is traced; when it changes, raise the version, so that no older picture is used on. */
    @Test
    void aPictureKeptUnderThisVersionIsStillRight() {
        assertEquals(1, ReferencePicture.VERSION);
        var light = new Light.Point("lamp", new Vec3(1, 2.5, 1), Stage.grey(3), 8, true);
        var body = new Body.Sphere("ball", new Vec3(1.2, 0.3, 1), 0.3, 1, "gloss", 0.5, 0.5);
        float[] rgb = stage().sun(new Vec3(0.3, 0.8, 0.4), 2)
                .fog(0.05, new Vec3(0.3, 0.4, 0.5))
                .gloss("gloss", new Vec3(0.8, 0.5, 0.2), 0.3, 0.7)
                .light(light)
                .body(body)
                .portal("a", "b", new Vec3(0, 1, 0.5), new Vec3(0, 0, 1))
                .portal("b", "a", new Vec3(-0.5, 1, 0), new Vec3(-1, 0, 0))
                .picture(EYE, new TraceSettings(48, 36, 16, 1, 2));
        double weighted = 0;
        for (int i = 0; i < rgb.length; i++) {
            weighted += rgb[i] * (1 + i % 97);
        }
        assertEquals(22.65127248, weighted / rgb.length, 1e-6);
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum / values.length;
    }
}
