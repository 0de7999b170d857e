package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.host.draw.QualityChoice;
import org.junit.jupiter.api.Test;

/** Fog between the eye and mirrors keeps its colour; everything behind a mirror is tinted, fog included. */
class MirrorFogGlTest {
    private static final int WIDTH = 32;
    private static final int HEIGHT = 24;
    private static final double EXTINCTION = 0.2;
    private static final Vec3 FOG = new Vec3(0.4, 0.5, 0.6);
    private static final Vec3 AHEAD = new Vec3(0.5, 0.6, 0.8);
    private static final Vec3 BEHIND = new Vec3(0.9, 0.3, 0.7);
    /** Four sums in half precision, which Mesa's llvmpipe 22.3 truncates. */
    private static final double ROUNDING = 3e-3;

    private static final Vec3 SILVER = new Vec3(1, 1, 1);

    /** Returns two mirrors that fill every view of each other, 3 m before the eye and 5 m behind it. */
    private static TestLevel facing(Vec3 ahead, Vec3 behind) {
        return new TestLevel()
                .material(new Material("ahead", ahead, null, null, null, null, Vec3.ZERO, 1, true))
                .material(new Material("behind", behind, null, null, null, null, Vec3.ZERO, 1, true))
                .solid(wall(-3.5, BoxFace.PLUS_Z, "ahead"))
                .solid(wall(5.5, BoxFace.MINUS_Z, "behind"));
    }

    private static Solid wall(double z, BoxFace face, String mirror) {
        return new Solid.Box(
                mirror,
                null,
                false,
                TextureMapping.WORLD,
                new Vec3(0, 0, z),
                new Vec3(200, 200, 1),
                Map.of(face, new Solid.Face(mirror, null, null)));
    }

    /** Returns the radiance with two mirrors on the path, and a third one beyond which there is only fog. */
    private static double expected(double ahead, double behind, double fog, double secant) {
        double seen = fog * (1 - ahead) * (1 - Math.exp(-EXTINCTION * 3 * secant));
        seen += fog * ahead * (1 - behind) * (1 - Math.exp(-EXTINCTION * 11 * secant));
        seen += fog * ahead * behind * (1 - ahead) * (1 - Math.exp(-EXTINCTION * 19 * secant));
        return seen + fog * ahead * behind * ahead;
    }

    @Test
    void fogBeforeEachMirrorIsTintedByThoseBeforeItAlone() {
        Level level = facing(AHEAD, BEHIND).fog(EXTINCTION, FOG).level();
        try (Offscreen offscreen = new Offscreen(WIDTH, HEIGHT)) {
            for (PortalTechnique technique : List.of(PortalTechnique.STENCIL, PortalTechnique.TEXTURE)) {
                Quality quality = Quality.HIGH
                        .with("portalTechnique", technique)
                        .with("portalResolution", 1)
                        .with("viewBudget", 2);
                RenderSettings settings = RenderSettings.of(Output.HDR, quality);
                try (Renderer renderer = LevelRenderer.load(offscreen.gl, level, TestAssets.NONE, settings)) {
                    renderer.draw(offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1)), offscreen.picture);
                    assertFog(renderer.readRadiance(), technique);
                }
            }
        }
    }

    private static void assertFog(float[] rgb, PortalTechnique technique) {
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double across = (2 * x + 1 - WIDTH) / (double) HEIGHT;
                double up = (2 * y + 1 - HEIGHT) / (double) HEIGHT;
                double secant = Math.sqrt(1 + across * across + up * up);
                int i = 3 * (y * WIDTH + x);
                String where = technique + " at " + x + ", " + y;
                assertEquals(expected(AHEAD.x(), BEHIND.x(), FOG.x(), secant), rgb[i], ROUNDING, where);
                assertEquals(expected(AHEAD.y(), BEHIND.y(), FOG.y(), secant), rgb[i + 1], ROUNDING, where);
                assertEquals(expected(AHEAD.z(), BEHIND.z(), FOG.z(), secant), rgb[i + 2], ROUNDING, where);
            }
        }
    }

    /**
     * A tinted mirror in fog requires a linear target, since light can be added only before the tone curve; nothing
     * else does.
     */
    @Test
    void fogBeforeATintedMirrorAsksForLinearLight() {
        assertEquals(
                Output.HDR,
                QualityChoice.defaultOutput(
                        facing(AHEAD, SILVER).fog(EXTINCTION, FOG).level()));
        assertEquals(
                Output.DIRECT,
                QualityChoice.defaultOutput(
                        facing(SILVER, SILVER).fog(EXTINCTION, FOG).level()));
        assertEquals(
                Output.DIRECT, QualityChoice.defaultOutput(facing(AHEAD, BEHIND).level()));
    }
}
