package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.render.frame.PortalTechnique;
import org.junit.jupiter.api.Test;

/**
 * Eyes that pass through a portal never see its wall, at a reduced count; {@code prove eye-crossings} moves 10⁴ eyes.
 */
class EyeCrossingsGlTest {
    @Test
    void noFrameShowsTheWallOnTheWayThrough() {
        for (PortalTechnique technique : PortalTechnique.values()) {
            assertNoWall(technique);
        }
    }

    private static void assertNoWall(PortalTechnique technique) {
        try (EyeCrossings crossings = new EyeCrossings(technique)) {
            for (int i = 0; i < 60; i++) {
                crossings.cross(1000 + i);
            }
            assertEquals(60, crossings.crossed());
            assertEquals(0, crossings.badFrames(), "of " + crossings.frames() + " frames");
            assertTrue(crossings.frames() >= 360);
        }
    }
}
