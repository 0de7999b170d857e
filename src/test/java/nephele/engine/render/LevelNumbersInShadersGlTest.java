package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.lwjgl.opengl.GL41C.glIsProgram;

import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.asset.LevelAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A level's number reaches a shader as a uniform, never as a constant: a level that differs from another only in numbers
 * compiles no program of its own, and no number can make a compiler drop what a pass looks up.
 */
@TestInstance(Lifecycle.PER_CLASS)
class LevelNumbersInShadersGlTest {
    private static final Path SAMPLES = Path.of("levels", "samples");

    /** The parts of a level whose numbers are tried: light, air, sky, clouds, weather and looks. */
    private static final List<String> PARTS = List.of("environment", "materials", "lights", "emitters");

    private static final double LITTLE = 0.984375;

    private static final RenderSettings SETTINGS = RenderSettings.of(Output.HDR, Quality.LOW);

    private final Offscreen offscreen = new Offscreen(16, 9);

    @AfterAll
    void close() {
        offscreen.close();
    }

    private int programs(Level level, Path file) {
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, LevelAssets.beside(file), SETTINGS)) {
            renderer.draw(offscreen.view(new Vec3(0, 1.7, 3), new Vec3(0, 1.5, -5)), offscreen.picture);
            offscreen.gl.requireNoError("frame");
        }
        return linked();
    }

    private static int linked() {
        return (int) IntStream.range(1, 1000).filter(id -> glIsProgram(id)).count();
    }

    /** Changes each decimal number of a value's records a little; 0 stays, so that what there is stays there. */
    private static Object changed(Object value) {
        if (value instanceof Double number) {
            return LITTLE * number;
        }
        if (value instanceof List<?> list) {
            return list.stream().map(LevelNumbersInShadersGlTest::changed).toList();
        }
        return value instanceof Record all ? rebuilt(all, name -> true) : value;
    }

    private static Record rebuilt(Record record, Predicate<String> isChanged) {
        RecordComponent[] components = record.getClass().getRecordComponents();
        try {
            Object[] values = new Object[components.length];
            for (int i = 0; i < values.length; i++) {
                components[i].getAccessor().setAccessible(true);
                Object value = components[i].getAccessor().invoke(record);
                values[i] = isChanged.test(components[i].getName()) ? changed(value) : value;
            }
            Class<?>[] types =
                    Stream.of(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
            return record.getClass().getDeclaredConstructor(types).newInstance(values);
        } catch (ReflectiveOperationException impossible) {
            throw new AssertionError(impossible);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sky-skybox-faces", "lamps", "emitters", "exits"})
    void aLevelThatDiffersOnlyInNumbersCompilesNothingOfItsOwn(String sample) {
        Path file = SAMPLES.resolve(sample + ".json");
        Level written = LevelFile.read(file);
        Level other = (Level) rebuilt(written, PARTS::contains);
        assertNotEquals(written, other);
        int before = programs(written, file);
        assertEquals(before, programs(other, file), "programs of " + sample);
    }

    /** At 0 the compiler dropped the pictures, and the pass that looks them up failed. */
    @ParameterizedTest
    @ValueSource(doubles = {0, Double.MIN_VALUE, 1e-30, 1e9})
    void aSkyboxOfAnyWhiteIsDrawn(double white) {
        Path file = SAMPLES.resolve("sky-skybox-faces.json");
        Level written = LevelFile.read(file);
        Sky.Skybox sky = (Sky.Skybox) written.environment().sky();
        var scaled = new Sky.Skybox(sky.layout(), sky.files(), white);
        int before = programs(written, file);
        assertEquals(before, programs(written.with(written.environment().with(scaled), written.lights()), file));
    }
}
