package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.render.Capture;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The proof {@code portal-light} holds for one camera of small pictures, in levels with little approximation. */
@Order(1) // one of the longest
class PortalLightProofGlTest {
    private static final String FOG = "levels/samples/fog.json";
    private static final String PRISM = "levels/samples/solid-prism.json";

    @TempDir
    Path kept;

    private ProofResult judged(List<String> levels, int width, long from, long count) throws Exception {
        var proof = new PortalLightProof(levels, width, 16, kept);
        return proof.judged(proof.run(from, count, Proof.Progress.NONE));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                FOG,
                PRISM,
                "levels/samples/lamps.json",
                "levels/samples/sun-shadow.json",
                "levels/samples/material-roughness.json",
                "levels/samples/sky-skybox-faces.json",
                "levels/samples/exits.json",
                "levels/01-courtyard.json"
            })
    void litPicturesLookLikeTheTwins(String level) throws Exception {
        var result = judged(List.of(level), 160, 0, 1);
        assertEquals(List.of(), result.examples());
        assertEquals(2, result.figure("pictures").orElseThrow().value());
    }

    /**
     * Pictures with openings over 6 % to 57 % of their area are within the full proof's limits at a ninth of its
     * pixels, by both techniques, each with a renderer of its own.
     */
    @ParameterizedTest
    @CsvSource({
        "levels/samples/straddling-cube.json, 6",
        "levels/samples/slanted-walls.json, 8",
        "levels/samples/models.json, 3"
    })
    void litPicturesThroughPortalsLookLikeTheTwins(String level, int camera) throws Exception {
        var result = judged(List.of(level), 96, camera, 1);
        assertEquals(List.of(), result.examples());
        assertEquals(2, result.figure("pictures").orElseThrow().value());
    }

    /**
     * Traced pictures are reused: after the light in each kept file is doubled, the drawn pictures are too dark by
     * half.
     */
    @Test
    void aTracedPictureIsKept() throws Exception {
        // The fifth camera of one level is followed by the first of the other.
        var levels = List.of(FOG, PRISM);
        judged(levels, 32, 4, 2);
        for (Path file : files()) {
            byte[] bytes = Files.readAllBytes(file);
            var floats = ByteBuffer.wrap(bytes, bytes.length - 12 * 32 * 18, 12 * 32 * 18)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .asFloatBuffer();
            float[] rgb = new float[floats.remaining()];
            floats.get(rgb);
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] *= 2;
            }
            Capture.pfm(rgb, 32, 18, file);
        }
        var result = judged(levels, 32, 4, 2);
        assertEquals(2, files().size(), "one picture a level, however often it is compared");
        assertEquals(4, result.failures());
        assertTrue(result.examples().stream().allMatch(line -> line.contains("bias -5") || line.contains("bias -4")));
    }

    private List<Path> files() throws IOException {
        try (var all = Files.list(kept)) {
            return all.toList();
        }
    }
}
