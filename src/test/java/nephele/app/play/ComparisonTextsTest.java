package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Language;
import nephele.host.compare.PictureDifference;
import nephele.host.compare.TechniquePair;
import org.junit.jupiter.api.Test;

/** The sentence about two techniques names them in its own language. */
class ComparisonTextsTest {
    private static final TechniquePair PAIR = TechniquePair.parse("particles,volume");

    @Test
    void theDifferenceNamesTheTechniquesInItsLanguage() {
        PictureDifference difference = new PictureDifference(0.125, 0.024);
        assertEquals(
                "particles differs from volume by FLIP 0.125, mean light +2.4 %",
                ComparisonTexts.difference(PAIR, difference, Language.EN));
        assertEquals(
                "partículas difere de volume por FLIP 0.125, luz média +2.4 %",
                ComparisonTexts.difference(PAIR, difference, Language.PT_PT));
        assertEquals("", ComparisonTexts.difference(PAIR, null, Language.PT_BR));
    }
}
