package nephele.engine.render.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.octave.OctaveSheet;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;
import nephele.engine.render.TwinProgram;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.pass.cloud.procedural.ProceduralTechnique;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/** The shader's octaves of noise are the Java twin's at any place and time. */
@TestInstance(Lifecycle.PER_CLASS)
class OctavesGlTest {
    private static final int COUNT = 400;

    private final GlContext gl = GlContext.offscreen();

    @AfterAll
    void close() {
        gl.close();
    }

    static OctaveSheet sheet(ProceduralNoise kind, double evolutionSeconds) {
        var cloud = new Cloud(
                "octaves",
                new Cloud.Extent.Layer(1000, 300),
                CloudTechnique.PROCEDURAL,
                new Cloud.Density.Noise(77, 600, 0.4),
                0.02,
                1,
                0.85,
                new Cloud.Motion(Vec3.ZERO, evolutionSeconds));
        return OctaveSheet.of(cloud, kind, 300, 2.5);
    }

    @Test
    void theShaderIsTheJavaTwin() {
        var eyes = List.of(Vec3.ZERO, new Vec3(1e6 + 0.37, 0, -1e6), new Vec3(-1234567.8, 0, 7654321.1));
        for (ProceduralNoise kind : ProceduralNoise.values()) {
            for (Vec3 eye : eyes) {
                for (double seconds : new double[] {0, 33.25, 30 * 86400 + 7.5}) {
                    compare(kind, eye, seconds);
                }
            }
        }
    }

    private void compare(ProceduralNoise kind, Vec3 eye, double seconds) {
        OctaveSheet sheet = sheet(kind, 64);
        String shader = kind.isSmooth() ? "cloud-octaves.frag" : "cloud-white-octaves.frag";
        float[] inputs = new float[4 * COUNT];
        var random = new SplittableRandom(5);
        for (int i = 0; i < COUNT; i++) {
            inputs[4 * i] = (float) random.nextDouble(-9000, 9000);
            inputs[4 * i + 1] = (float) random.nextDouble(-9000, 9000);
            inputs[4 * i + 2] = 1e6f;
        }
        float[] results = TwinProgram.run(
                gl, shader, inputs, COUNT, uniforms -> uniforms.record(ProceduralTechnique.Octaves.class)
                        .put(sheet, eye, seconds));
        double mean = 0;
        for (int i = 0; i < COUNT; i++) {
            double x = eye.x() + inputs[4 * i];
            double z = eye.z() + inputs[4 * i + 1];
            assertEquals(sheet.at(x, z, seconds), results[3 * i], 2e-4, eye + " at " + seconds);
            assertEquals(sheet.octaves().get(0).at(x, z, seconds), results[3 * i + 2], 2e-4);
            mean += results[3 * i] / (double) COUNT;
        }
        // Seen from far away a column is the mean of all.
        assertEquals(mean, results[1], 0.3 * mean + 0.02, kind + " " + eye + " " + seconds);
        assertTrue(mean > 0);
    }
}
