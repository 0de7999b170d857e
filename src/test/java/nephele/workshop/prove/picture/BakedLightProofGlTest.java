package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import nephele.engine.bake.LightBake;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The proof {@code baked-light} holds for a small picture of the room with sun and sky in its window. */
class BakedLightProofGlTest {
    private static final int SUNROOM = 1;

    @Test
    void aDrawnRoomHasTheLightOfItsTracedTwin(@TempDir Path kept) {
        var proof = new BakedLightProof(new LightBake.Settings(0.1, 128), 32, 4, kept);
        assertEquals(List.of(), proof.run(SUNROOM, 1, Proof.Progress.NONE).examples());
    }
}
