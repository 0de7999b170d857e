package nephele.engine.render.pass.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Models receive shadows. */
class ModelShadowGlTest {
    private static final double HALF_METRES = 1.5;
    private static final double THICK_METRES = 0.1;

    private static final Vec3[] SUNS = {
        new Vec3(0.3, 1, 0.2), new Vec3(1, 0.15, 0.3), new Vec3(0.7, 0.7, -0.7), new Vec3(0.05, 0.2, 1)
    };

    /** Returns six walls, and models that touch them or nearly do. */
    private static TestLevel closedRoom(Vec3 sun) {
        double inner = 2 * HALF_METRES;
        double outer = inner + 2 * THICK_METRES;
        double middle = HALF_METRES + THICK_METRES / 2;
        TestLevel room = new TestLevel().castingSun(sun, 1000).ambient(0).material("m", TestLevel.grey(0.8));
        for (int side = -1; side <= 1; side += 2) {
            room.box("m", new Vec3(0, side * middle, 0), new Vec3(outer, THICK_METRES, outer))
                    .box("m", new Vec3(side * middle, 0, 0), new Vec3(THICK_METRES, inner, inner))
                    .box("m", new Vec3(0, 0, side * middle), new Vec3(outer, inner, THICK_METRES));
        }
        return room.model("sphere_0.6_32_24.3d", "m", new Translate(new Vec3(0.9, 0.9, 0)))
                .model("torus_0.5_0.2_32_16.3d", "m", new Translate(new Vec3(-0.8, -1.3, -0.8)))
                .model("box_0.8_1.3d", "m", new Translate(new Vec3(1.1, -1.1, -1.1)))
                .model("cone_0.5_1.5_24_3.3d", "m", new Translate(new Vec3(-1, -1.5, 1)));
    }

    @Test
    void aClosedRoomIsDark() {
        try (Offscreen offscreen = new Offscreen(160, 160)) {
            List<View> views = List.of(
                    offscreen.view(new Vec3(-1.2, 1.2, 1.2), new Vec3(0.3, -0.3, 0)),
                    offscreen.view(new Vec3(0.2, -0.4, -0.2), new Vec3(1, 1, 0.2)),
                    offscreen.view(new Vec3(-1.3, 0, -1.2), new Vec3(0.3, -0.3, 0)));
            for (Vec3 sun : SUNS) {
                for (float[] seen : offscreen.radiance(closedRoom(sun).level(), TestAssets.NONE, views)) {
                    int lit = 0;
                    for (float value : seen) {
                        lit += value > 0 ? 1 : 0;
                    }
                    assertEquals(0, lit, "values lit by a sun towards " + sun);
                }
            }
        }
    }
}
