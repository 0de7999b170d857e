package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.Scene;
import nephele.engine.scene.probe.ChartLight;
import org.junit.jupiter.api.Test;

/** Moving things in rooms whose walls have baked light. */
class BouncedLightGlTest {
    private static final int SIZE = 32;
    private static final double OF_WALLS = 0.5;
    private static final double OF_CUBE = 0.8;
    private static final Vec3 LIGHT = new Vec3(2, 1, 0.5);

    private final TestLevel room = new TestLevel()
            .skyLight()
            .material("wall", new Vec3(OF_WALLS, OF_WALLS, OF_WALLS))
            .material("cube", new Vec3(OF_CUBE, OF_CUBE, OF_CUBE))
            .gloss("metal", new Vec3(OF_CUBE, OF_CUBE, OF_CUBE), 0.4, 1)
            .box("wall", new Vec3(0, -2.1, 0), new Vec3(4, 0.2, 4))
            .box("wall", new Vec3(0, 2.1, 0), new Vec3(4, 0.2, 4))
            .box("wall", new Vec3(-2.1, 0, 0), new Vec3(0.2, 4, 4))
            .box("wall", new Vec3(2.1, 0, 0), new Vec3(0.2, 4, 4))
            .box("wall", new Vec3(0, 0, -2.1), new Vec3(4, 4, 0.2))
            .box("wall", new Vec3(0, 0, 2.1), new Vec3(4, 4, 0.2));

    private float[] middle(Scene scene) {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE);
                Renderer renderer = LevelRenderer.load(offscreen.gl, scene, RenderSettings.of(Output.HDR))) {
            renderer.draw(offscreen.view(new Vec3(0, 0, 1), Vec3.ZERO), offscreen.picture);
            offscreen.gl.requireNoError("test frame");
            float[] radiance = renderer.readRadiance();
            int at = 3 * (SIZE / 2 * SIZE + SIZE / 2);
            return new float[] {radiance[at], radiance[at + 1], radiance[at + 2]};
        }
    }

    @Test
    void cubeReflectsTheLightOfTheWalls() {
        float[] rgb = middle(ChartLight.scene(room.cube("cube", Vec3.ZERO, 1), chart -> LIGHT));
        assertEquals(OF_CUBE * OF_WALLS * LIGHT.x(), rgb[0], 2e-2 * rgb[0]);
        assertEquals(OF_CUBE * OF_WALLS * LIGHT.y(), rgb[1], 2e-2 * rgb[1]);
        assertEquals(OF_CUBE * OF_WALLS * LIGHT.z(), rgb[2], 2e-2 * rgb[2]);
    }

    /** The wall behind the eye alone is bright, and a cube of metal mirrors it. */
    @Test
    void metalReflectsWhatItMirrors() {
        float[] rgb = middle(
                ChartLight.scene(room.cube("metal", Vec3.ZERO, 1), chart -> chart.z() > 1.99 ? LIGHT : Vec3.ZERO));
        float[] aside = middle(
                ChartLight.scene(room.cube("metal", Vec3.ZERO, 1), chart -> chart.z() < -1.99 ? LIGHT : Vec3.ZERO));
        assertEquals(0, aside[0], 0.01 * rgb[0], "from behind the cube");
        double ofRoom = OF_CUBE * OF_WALLS * LIGHT.x();
        assertTrue(rgb[0] > 0.3 * ofRoom && rgb[0] < 0.8 * ofRoom, rgb[0] + " of " + ofRoom);
    }
}
