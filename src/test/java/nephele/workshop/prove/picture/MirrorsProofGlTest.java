package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The proof {@code mirrors} holds for one camera and smaller lit pictures. */
class MirrorsProofGlTest {
    @TempDir
    Path kept;

    @Test
    void mirrorsShowWhatTheTwinShows() throws Exception {
        var proof = new MirrorsProof(64, 4, kept);
        var result = proof.judged(proof.run(0, 1, Proof.Progress.NONE));
        assertEquals(1, result.units());
        var wrong = result.figure("pixels that show another surface").orElseThrow();
        assertEquals(0, wrong.value(), result.examples().toString());
    }
}
