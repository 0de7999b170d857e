package nephele.engine.render.pass.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import nephele.engine.asset.TestAssets;
import nephele.engine.atmosphere.AtmosphereRow;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import org.junit.jupiter.api.Test;

class AtmosphereGlTest {
    /** The sun's irradiance, which keeps twilight well inside half floats. */
    private static final double BRIGHT = 1000;

    /** Pixels of less than a degree: the sun's disc is in none but its own. */
    private static final int SIDE = 129;

    private static final int MIDDLE = 3 * (SIDE * SIDE / 2);

    /** As that of the table; it is not drawn. */
    private static final Sky POINT_SUN = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, 172, 10, 0, 0);

    private static Level level(double sunDegrees) {
        double sun = Math.toRadians(sunDegrees);
        Vec3 towards = new Vec3(0, Math.sin(sun), -Math.cos(sun));
        return new TestLevel().sky(POINT_SUN).sun(towards, BRIGHT).level();
    }

    @Test
    void theDrawnSkyIsThatOfTheMonteCarloTableAtEveryRow() {
        List<AtmosphereRow> rows = AtmosphereRow.read("atmosphere.csv");
        var bySun = rows.stream()
                .sorted(Comparator.comparingDouble(AtmosphereRow::eyeHeight))
                .collect(Collectors.groupingBy(AtmosphereRow::sunElevation));
        int checked = 0;
        for (var group : bySun.entrySet()) {
            try (Offscreen offscreen = new Offscreen(SIDE, SIDE);
                    Renderer renderer = LevelRenderer.load(
                            offscreen.gl, level(group.getKey()), new TestAssets(), RenderSettings.of(Output.HDR))) {
                for (AtmosphereRow row : group.getValue()) {
                    Vec3 eye = new Vec3(0, row.eyeHeight(), 0);
                    // The vertical has no right-hand side.
                    Vec3 target = eye.plus(row.direction()).plus(new Vec3(1e-5, 0, 0));
                    renderer.draw(offscreen.view(eye, target), offscreen.picture);
                    float[] drawn = renderer.readRadiance();
                    Vec3 perIrradiance =
                            new Vec3(drawn[MIDDLE] / BRIGHT, drawn[MIDDLE + 1] / BRIGHT, drawn[MIDDLE + 2] / BRIGHT);
                    assertTrue(row.isMetBy(perIrradiance, 0.05, 0.005), row.text() + ": " + perIrradiance);
                    checked++;
                }
                offscreen.gl.requireNoError("test frames");
            }
        }
        assertEquals(460, checked);
    }
}
