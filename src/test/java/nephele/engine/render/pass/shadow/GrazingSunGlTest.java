package nephele.engine.render.pass.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/**
 * Faces under grazing light from any side are lit correctly: over a texel of the shadow map, their depth changes by
 * many metres.
 */
class GrazingSunGlTest {
    private static final int SIZE = 24;
    private static final double AMBIENT = 0.05;
    /** Sine of the sun's elevation over the face. */
    private static final double ELEVATION_SINE = 0.05;

    private static final Vec3 SIDES = new Vec3(2, 2, 2);

    private static TestLevel level(Vec3 sun) {
        return new TestLevel()
                .ambient(AMBIENT)
                .material("white", TestLevel.grey(1))
                .castingSun(sun, Math.PI);
    }

    @Test
    void aSolidsFacesAreLitAsTheirCosineSays() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (int face = 0; face < 6; face++) {
                Vec3 sun = sun(face);
                // A single solid could not be in a shadow, and the map would not be looked up.
                Vec3 away = new Vec3(-4 * sun.x(), -4 * sun.y(), -4 * sun.z());
                Level level = level(sun)
                        .box("white", Vec3.ZERO, SIDES)
                        .box("white", away, new Vec3(0.5, 0.5, 0.5))
                        .level();
                assertLit(offscreen, level, face, sun);
            }
        }
    }

    @Test
    void aBodysFacesAreLitAsTheirCosineSays() {
        Body body = new Body.Box("b", Vec3.ZERO, SIDES, 1, "white", 0, 0);
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            for (int face = 0; face < 6; face++) {
                Vec3 sun = sun(face);
                assertLit(offscreen, level(sun).body(body).level(), face, sun);
            }
        }
    }

    private static Vec3 axis(int axis, double length) {
        return new Vec3(axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0);
    }

    private static Vec3 normal(int face) {
        return axis(face / 2, face % 2 == 0 ? 1 : -1);
    }

    /** Returns a direction just above the face, 22.5° from one of its edges; for opposite faces from opposite sides. */
    private static Vec3 sun(int face) {
        double angle = Math.PI / 8 + face % 2 * Math.PI;
        double level = Math.sqrt(1 - ELEVATION_SINE * ELEVATION_SINE);
        Vec3 n = normal(face);
        Vec3 a = axis((face / 2 + 1) % 3, level * Math.cos(angle));
        Vec3 b = axis((face / 2 + 2) % 3, level * Math.sin(angle));
        return new Vec3(
                ELEVATION_SINE * n.x() + a.x() + b.x(),
                ELEVATION_SINE * n.y() + a.y() + b.y(),
                ELEVATION_SINE * n.z() + a.z() + b.z());
    }

    private static void assertLit(Offscreen offscreen, Level level, int face, Vec3 sun) {
        Vec3 n = normal(face);
        Vec3 eye = new Vec3(3 * n.x(), 3 * n.y(), 3 * n.z());
        Vec3 up = face / 2 == 1 ? new Vec3(0, 0, 1) : new Vec3(0, 1, 0);
        View view = View.lookAt(eye, Vec3.ZERO, up, new Projection(Math.toRadians(40), 1, 0.1, 100));
        RenderSettings settings = RenderSettings.of(Output.HDR).with(Decoration.OFF);
        try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
            renderer.draw(view, offscreen.picture);
            float[] rgb = renderer.readRadiance();
            for (int i = 0; i < rgb.length; i += 3) {
                int pixel = i / 3;
                assertEquals(
                        AMBIENT + ELEVATION_SINE,
                        rgb[i],
                        1e-3,
                        () -> "pixel " + pixel + " of face " + face + ", sun " + sun);
            }
        }
    }
}
