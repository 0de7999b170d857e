package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The proof {@code shadow-edges} holds for a few pictures under sun, point light and spot light. */
class ShadowEdgesProofGlTest {
    /**
     * Rooms with sun and lights; in the later ones the light grazes a wall, or is so far away that a texel is as wide
     * as a wall is thick.
     */
    private static final int[] ROOMS = {0, 1, 2, 6, 8, 10, 13, 18, 23, 104, 321, 361};

    @ParameterizedTest
    @ValueSource(longs = {2, 3, 25})
    void shadowsEndWithinATexelOfWhereRaysSay(long unit) {
        var result = new ShadowEdgesProof().run(unit, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(result.figures().get(1).value() > 0, "edges are in the picture, and pixels beside them differ");
    }

    /** A closed room is dark inside; with a gap of 20 cm between ceiling and walls the same eye sees light. */
    @Test
    void onlyAGapLetsLightIn() {
        try (var gl = GlContext.offscreen();
                var picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, 320, 180)) {
            int through = 0;
            for (int unit : ROOMS) {
                assertEquals(0, ShadowEdgesProof.litPixels(unit, 0, gl, picture), "room " + unit);
            }
            for (int unit = 0; unit < 5; unit++) {
                through += ShadowEdgesProof.litPixels(unit, 0.2, gl, picture);
            }
            assertTrue(through > 0, "light comes through the gap");
        }
    }
}
