package nephele.host.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.CloudTechnique;
import nephele.engine.level.TestLevel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class WipeTest {
    @ParameterizedTest
    @CsvSource({"-3, 0", "0, 0", "0.25, 25", "0.999, 100", "1, 100", "Infinity, 100", "-Infinity, 0", "NaN, 50"})
    void theLineStaysInThePicture(double share, int column) {
        assertEquals(column, new Wipe(share).column(100));
    }

    @Test
    void aMovedWipeStopsAtTheEdges() {
        assertEquals(new Wipe(1), new Wipe(0.9).moved(0.4));
        assertEquals(new Wipe(0), new Wipe(0.1).moved(-0.4));
    }

    @Test
    void namesOfTechniquesAreRead() {
        var pair = TechniquePair.parse("Particles, volume");
        assertEquals(new TechniquePair(CloudTechnique.PARTICLES, CloudTechnique.VOLUME), pair);
        assertEquals(CloudTechnique.VOLUME, pair.reference());
        assertEquals(CloudTechnique.PARTICLES, pair.tried());
        assertEquals(
                CloudTechnique.SKYPLANE,
                TechniquePair.parse("skyplane,billboard").reference());
    }

    @ParameterizedTest
    @ValueSource(strings = {"volume", "", ",", "volume,", "volume,puffs", "volume,particles,auto"})
    void whatIsNotTwoTechniquesIsAnsweredWithAllNames(String text) {
        var wrong = assertThrows(IllegalArgumentException.class, () -> TechniquePair.parse(text));
        assertTrue(
                wrong.getMessage().contains("auto, skybox, skyplane, procedural, billboard, particles, volume"),
                wrong.getMessage());
    }

    @Test
    void aLevelWithoutCloudsHasNothingToCompare() {
        assertTrue(TechniquePair.obstacle(new TestLevel().level()).orElseThrow().contains("no cloud"));
    }
}
