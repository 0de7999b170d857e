package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The same code as `prove portal-light`, for one camera of small pictures: the bounds hold where little is approximated. */
class PortalLightProofGlTest {
    @ParameterizedTest
    @ValueSource(strings = {"levels/samples/fog.json", "levels/samples/solid-prism.json", "levels/samples/lamps.json"})
    void litPicturesLookLikeTheTwins(String level) throws Exception {
        var result = new PortalLightProof(List.of(level), 160, 16).run(0, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(
                result.figures().stream().anyMatch(figure -> figure.name().equals("pictures") && figure.value() == 2));
    }

    /**
     * Openings fill 6 % and 57 % of these pictures; both techniques, each with a renderer of its own; the full proof's
     * bounds at a ninth of its pixels.
     */
    @ParameterizedTest
    @CsvSource({"levels/samples/straddling-cube.json, 6", "levels/samples/slanted-walls.json, 8"})
    void litPicturesThroughPortalsLookLikeTheTwins(String level, int camera) throws Exception {
        var result = new PortalLightProof(List.of(level), 96, 16).run(camera, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(
                result.figures().stream().anyMatch(figure -> figure.name().equals("pictures") && figure.value() == 2));
    }
}
