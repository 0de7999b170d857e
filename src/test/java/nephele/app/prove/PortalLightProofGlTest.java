package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
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
     * A camera that sees an opening, by both techniques, each with a renderer of its own: the full proof's bounds at a
     * ninth of its pixels.
     */
    @ParameterizedTest
    @ValueSource(strings = {"levels/samples/straddling-cube.json", "levels/samples/slanted-walls.json"})
    void litPicturesThroughPortalsLookLikeTheTwins(String level) throws Exception {
        var result = new PortalLightProof(List.of(level), 96, 16).run(1, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertTrue(
                result.figures().stream().anyMatch(figure -> figure.name().equals("pictures") && figure.value() == 2));
    }
}
