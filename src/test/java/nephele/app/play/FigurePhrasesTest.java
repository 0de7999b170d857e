package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import java.util.Map;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Language;
import nephele.engine.render.RenderFeatures;
import nephele.engine.render.frame.RenderFeature;
import nephele.host.compare.TechniquePair;
import nephele.host.draw.QualityChoice;
import nephele.host.draw.QualityFront;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;

/** The panel of figures and the comparison of techniques speak the player's language; in English they say names of files. */
class FigurePhrasesTest {
    @Test
    void everyStepOfAFrameHasAName() {
        for (RenderFeature feature : RenderFeatures.ALL) {
            Phrase step = Phrase.ofStep(feature.name());
            assertEquals(feature.name(), step.in(Language.EN), "as explain says it");
            assertNotEquals(feature.name(), step.in(Language.PT_BR));
            assertNotEquals(feature.name(), step.in(Language.PT_PT));
        }
        assertEquals("limpeza", Phrase.ofStep("clear").in(Language.PT_PT), "the step that belongs to no feature");
    }

    @Test
    void everyTechniqueHasAName() {
        for (CloudTechnique technique : CloudTechnique.values()) {
            assertEquals(
                    TechniquePair.name(technique), Phrase.ofTechnique(technique).in(Language.EN));
            assertFalse(Phrase.ofTechnique(technique).in(Language.PT_PT).isEmpty());
        }
        assertEquals("partículas", Phrase.ofTechnique(CloudTechnique.PARTICLES).in(Language.PT_BR));
    }

    @Test
    void everyPointOfAutomaticQualityHasAName() {
        for (QualityFront front : List.of(QualityFront.SOFTWARE, QualityFront.HARDWARE)) {
            for (QualityFront.Point point : front.points()) {
                assertEquals(point.name(), AutoQuality.name(point.name(), Language.EN));
                boolean isSame = point.name().equals("ultra");
                assertEquals(
                        isSame, AutoQuality.name(point.name(), Language.PT_BR).equals(point.name()), point.name());
            }
        }
        assertEquals("resolução 0.35", AutoQuality.name("resolution 0.35", Language.PT_PT));
    }

    @Test
    void theChosenQualityIsNamedInThePlayersLanguage() {
        PlayerFiles files = new PlayerFiles(new UserFolders(null, null, null));
        PlayRequest request = new PlayRequest(
                null,
                null,
                new QualityChoice("high", Map.of()),
                null,
                null,
                null,
                null,
                null,
                new PlayRequest.Player(files, null));
        var figure = new AutoQuality(files, "llvmpipe", true, null)
                .figures(request, Language.PT_BR)
                .get(0);
        assertEquals("qualidade", figure.name());
        assertEquals("alta", figure.value());
    }
}
