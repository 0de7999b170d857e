package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.render.frame.PortalTechnique;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/**
 * Eyes that pass through a portal never see its wall, at a reduced count; {@code prove eye-crossings} moves 10⁴ eyes.
 */
class EyeCrossingsGlTest {
    /** Each technique draws every crossing of its part of the units. */
    @Test
    void noFrameShowsTheWallOnTheWayThrough() {
        long crossings = 60L * PortalTechnique.values().length;
        ProofResult result = new EyeCrossingsProof().run(1000, crossings, Proof.Progress.NONE);
        assertEquals(crossings, result.value("eyes that came through"));
        assertEquals(0, result.value("frames that show a wall or nothing"));
        assertEquals(0, result.failures());
        assertEquals(6 * crossings, result.value("frames"));
    }
}
