package nephele.app.art;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.LevelJson;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The committed bench levels against their generator, and against the peers' formulas written down once more. */
class BenchLevelsTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "clear.json",
                "skybox.json",
                "boxes-1000.json",
                "boxes-10000.json",
                "boxes-500-stack.json",
                "bodies-200.json"
            })
    void committedFileIsWhatTheGeneratorMakes(String file) throws IOException {
        assertEquals(LevelJson.write(BenchLevels.all().get(file)), Files.readString(Path.of("levels/bench", file)));
    }

    @ParameterizedTest
    @CsvSource({"boxes-1000.json, 1000, 32", "boxes-10000.json, 10000, 100"})
    void boxesStandOnACentredGridOfSpacingTwo(String file, int count, int side) {
        Level level = BenchLevels.all().get(file);
        assertEquals(count, level.solids().size());
        for (int i = 0; i < count; i++) {
            Solid.Box box = (Solid.Box) level.solids().get(i);
            double x = 2.0 * (i - side * (i / side)) - (side - 1);
            double z = 2.0 * (i / side) - (side - 1);
            assertEquals(new Vec3(x, 0.5, z), box.centre());
            assertEquals(new Vec3(1, 1, 1), box.size());
        }
    }

    @ParameterizedTest
    @CsvSource({
        "clear.json, 0, 0, 0, 0.2617993878, 0, 0, 0",
        "skybox.json, 0, 0, 0, 0, 1, 0, 0.35",
        "boxes-1000.json, 3.2, 4.28, 16, 0.2617993878, 0, -0.15, 0",
        "boxes-10000.json, 10, 7, 50, 0.2617993878, 0, -0.15, 0"
    })
    void cameraFollowsThePeersPath(
            String file, double slide, double y, double z, double sway, int turns, double rise, double nod) {
        Camera camera = BenchLevels.all().get(file).cameras().get(0);
        assertEquals(60, camera.path().size());
        assertEquals(60, camera.verticalFovDegrees());
        for (int frame = 0; frame < 60; frame++) {
            double phase = frame * StrictMath.PI / 30;
            double yaw = turns * phase + sway * StrictMath.sin(phase);
            double up = rise + nod * StrictMath.sin(phase);
            double length = StrictMath.hypot(1, up);
            Vec3 eye = camera.path().get(frame).position();
            Vec3 target = camera.path().get(frame).target();
            assertArrayEquals(
                    new double[] {slide * StrictMath.sin(phase), y, z}, new double[] {eye.x(), eye.y(), eye.z()}, 1e-5);
            assertArrayEquals(
                    new double[] {StrictMath.sin(yaw) / length, up / length, -StrictMath.cos(yaw) / length},
                    new double[] {target.x() - eye.x(), target.y() - eye.y(), target.z() - eye.z()},
                    1e-5);
        }
    }

    @Test
    void lightGivesThePeersTexturesTimesAmbientPlusLambert() {
        Level level = BenchLevels.all().get("boxes-1000.json");
        assertEquals(0.8, level.environment().sun().irradiance().x() / StrictMath.PI, 1e-15);
        assertEquals(new Vec3(0.3, 0.3, 0.3), level.environment().ambient());
    }
}
