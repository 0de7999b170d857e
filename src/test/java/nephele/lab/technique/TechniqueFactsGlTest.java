package nephele.lab.technique;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.lwjgl.opengl.GL20C.*;
import static org.lwjgl.opengl.GL30C.GL_SAMPLER_2D_ARRAY;

import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.ImpostorChoice;
import nephele.engine.scene.View;
import nephele.host.named.Viewpoints;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.lwjgl.system.MemoryStack;

/** The draws and texture units of the table are those of the linked programs. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class TechniqueFactsGlTest {
    private static final View VIEW = Viewpoints.between(new Vec3(0, 2, 0), new Vec3(0, 120, -400), 60.0, 1);
    private static final Set<Integer> SAMPLERS = Set.of(GL_SAMPLER_2D, GL_SAMPLER_3D, GL_SAMPLER_2D_ARRAY);

    private final Offscreen offscreen = new Offscreen(16, 16);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private static Level level(CloudTechnique technique) {
        Cloud.Density density = technique == CloudTechnique.VOLUME
                ? new Cloud.Density.Noise(1, 100, 0.5, 0, CloudProfile.CUMULUS, null, 0)
                : new Cloud.Density.Ellipsoid();
        var cloud = new Cloud(
                "c",
                new Cloud.Extent.Volume(new Vec3(0, 150, -400), new Vec3(200, 100, 100)),
                technique,
                density,
                0.05,
                1,
                0.85);
        // One that changes reads the cells of two times.
        var drifting = RecordCopy.with(cloud, "motion", new Cloud.Motion(new Vec3(1, 0, 0), 0));
        List<Cloud> clouds = technique == null ? List.of() : List.of(drifting);
        var environment = new Environment(
                new Sun(new Vec3(0.3, 0.8, 0.2), new Vec3(3, 3, 3), true),
                new Sky.Constant(new Vec3(0.2, 0.3, 0.5)),
                null,
                Exposure.NEUTRAL,
                ToneCurve.CLIP,
                null,
                clouds);
        return Level.of("facts", "", environment, List.of());
    }

    private long draws(CloudTechnique technique) {
        RenderSettings settings = RenderSettings.of(Output.HDR, Quality.HIGH.with("impostors", ImpostorChoice.OFF));
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level(technique), TestAssets.NONE, settings)) {
            renderer.draw(VIEW, offscreen.picture);
            renderer.draw(VIEW, offscreen.picture);
            return renderer.draws();
        }
    }

    private static Set<Integer> programs() {
        Set<Integer> programs = new TreeSet<>();
        for (int id = 1; id < 400; id++) {
            if (glIsProgram(id)) {
                programs.add(id);
            }
        }
        return programs;
    }

    private static boolean isOfSkybox(int program) {
        return glGetUniformLocation(program, "skyAxes[0]") >= 0;
    }

    private static int samplers(int program) {
        int count = 0;
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer size = stack.mallocInt(1);
            IntBuffer type = stack.mallocInt(1);
            for (int i = 0; i < glGetProgrami(program, GL_ACTIVE_UNIFORMS); i++) {
                glGetActiveUniform(program, i, size, type);
                count += SAMPLERS.contains(type.get(0)) ? size.get(0) : 0;
            }
        }
        return count;
    }

    /** The skybox comes last: clouds of no other technique have compiled anything of it. */
    @Test
    void drawsAndTextureUnitsAreAsWritten() {
        long without = draws(null);
        List<CloudTechnique> techniques = new ArrayList<>(TechniquePagesTest.built());
        techniques.remove(CloudTechnique.SKYBOX);
        techniques.add(CloudTechnique.SKYBOX);
        for (CloudTechnique technique : techniques) {
            Set<Integer> before = programs();
            assertFalse(before.stream().anyMatch(TechniqueFactsGlTest::isOfSkybox), technique + ": a skybox before");
            long draws = draws(technique) - without;
            Set<Integer> added = programs();
            added.removeAll(before);
            int units = added.stream()
                    .mapToInt(TechniqueFactsGlTest::samplers)
                    .max()
                    .orElse(0);
            TechniqueText text = TechniqueText.of(technique);
            assertEquals(text.one("draws"), Long.toString(draws), technique + ": draws");
            assertEquals(text.one("units"), Integer.toString(units), technique + ": texture units");
        }
        assertTrue(programs().stream().anyMatch(TechniqueFactsGlTest::isOfSkybox), "a skybox after");
    }
}
