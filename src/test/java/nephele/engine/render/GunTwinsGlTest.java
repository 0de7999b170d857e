package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import nephele.engine.scene.ShotLook;
import nephele.engine.scene.dynamic.GunLight;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The light of the gun and of its shots is the same in shaders as in Java. */
class GunTwinsGlTest {
    private static final int COUNT = 512;

    @Test
    void theShadersAreTheJavaTwins() {
        SplittableRandom random = new SplittableRandom(8);
        float[] in = new float[8 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            in[8 * i] = (float) random.nextDouble();
            in[8 * i + 1] = (float) random.nextDouble(-1, 1);
            in[8 * i + 2] = (float) random.nextDouble();
            in[8 * i + 3] = (float) random.nextDouble(-0.1, 0.1);
            in[8 * i + 4] = (float) random.nextDouble(-0.1, 0.2);
            in[8 * i + 5] = (float) random.nextDouble(-0.4, 0.2);
            in[8 * i + 6] = (float) random.nextDouble(-3, 3);
        }
        float[] gpu = TwinProgram.run("shot.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            double across = in[8 * i + 1];
            double age = in[8 * i + 2];
            double shot = ShotLook.bolt(in[8 * i], across, age) + 2 * ShotLook.shimmer(Math.abs(across), age);
            var place = new Vector3d(in[8 * i + 3], in[8 * i + 4], in[8 * i + 5]);
            double angle = in[8 * i + 6];
            var normal = new Vector3d(Math.cos(angle), 0.6 * Math.sin(angle), 0.8 * Math.sin(angle));
            assertEquals(shot, gpu[3 * i], 2e-4, "shot " + i);
            assertEquals(GunLight.ofLamps(place, normal), gpu[3 * i + 1], 2e-4, "lamps " + i);
            assertEquals(GunLight.ofFlash(place, normal), gpu[3 * i + 2], 2e-4, "flash " + i);
        }
    }
}
