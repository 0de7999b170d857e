package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.LightParts;
import nephele.engine.scene.View;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LightPartsGlTest {
    private static final int SIZE = 48;

    private static Level level() {
        return new TestLevel()
                .skyLight()
                .sky(new Sky.Gradient(new Vec3(0.4, 0.6, 1), TestLevel.grey(0.8), TestLevel.grey(0.2)))
                .castingSun(new Vec3(0.5, 0.6, -0.4), 3)
                .light(new Light.Point("l", new Vec3(-2, 3, 1), TestLevel.grey(40), 40, false))
                .gloss("shiny", new Vec3(0.5, 0.3, 0.2), 0.3, 0.2)
                .material("matt", new Vec3(0.2, 0.5, 0.3))
                .box("shiny", new Vec3(0, -1, 0), new Vec3(200, 1, 200))
                .box("matt", new Vec3(0, 0.5, 0), new Vec3(2, 2, 2))
                .impostor("torus_1.5_0.45_24_12.3d", "matt")
                .level();
    }

    /** Light is a sum: the pictures of its parts make that of all. The ring is an impostor from afar, a mesh from close by. */
    @ParameterizedTest
    @CsvSource({"2, 12, 4", "2, 2.5, 1"})
    void partsSumUpToAll(double x, double y, double z) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(x, y, z), Vec3.ZERO);
            Quality quality = Quality.HIGH.with("impostorPixels", 32);
            List<float[]> parts = Stream.of(LightParts.ALL, LightParts.AMBIENT, LightParts.DIFFUSE, LightParts.SPECULAR)
                    .map(shown -> offscreen
                            .radiance(level(), new TestAssets(), List.of(view), quality.with("lightParts", shown))
                            .get(0))
                    .toList();
            double[] sums = new double[4];
            for (int i = 0; i < parts.get(0).length; i++) {
                float all = parts.get(0)[i];
                assertEquals(all, parts.get(1)[i] + parts.get(2)[i] + parts.get(3)[i], 2e-3 * all + 1e-4);
                for (int part = 0; part < sums.length; part++) {
                    sums[part] += parts.get(part)[i];
                }
            }
            for (double sum : sums) {
                assertTrue(sum > 0.01 * sums[0], "no part is without light");
            }
        }
    }
}
