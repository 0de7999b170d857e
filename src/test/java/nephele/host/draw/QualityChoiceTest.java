package nephele.host.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.render.frame.Output;
import nephele.host.terminal.CommandFailure;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class QualityChoiceTest {
    private static QualityChoice choice(String key, int value) {
        return new QualityChoice("low", Map.of(key, Integer.toString(value)));
    }

    private static void takesOnly(String key, int least, int most) {
        choice(key, least).check();
        choice(key, most).check();
        for (int value : List.of(least - 1, most + 1)) {
            var failure =
                    assertThrows(CommandFailure.class, () -> choice(key, value).check());
            assertTrue(failure.getMessage().contains("from " + least + " to " + most), failure.getMessage());
        }
    }

    @Test
    void everySettingHasItsRange() {
        takesOnly("shadowTexels", 64, 16384);
        takesOnly("anisotropy", 1, 16);
        takesOnly("samples", 1, 8);
        assertEquals(
                64,
                choice("shadowTexels", 64)
                        .settings(Output.DIRECT, true)
                        .quality()
                        .shadowTexels());
    }

    @ParameterizedTest
    @CsvSource({"low, 2, 2, 1, 1", "medium, 4, 4, 1, 1", "high, 4, 8, 1, 1", "ultra, 8, 16, 4, 8", "auto, 8, 16, 1, 1"})
    void aGraphicsCardDrawsMoreSamples(
            String preset, int samples, int anisotropy, int softwareSamples, int softwareAnisotropy) {
        var choice = new QualityChoice(preset, Map.of());
        var hardware = choice.settings(Output.DIRECT, false).quality();
        var software = choice.settings(Output.DIRECT, true).quality();
        assertEquals(samples, hardware.samples());
        assertEquals(anisotropy, hardware.anisotropy());
        assertEquals(softwareSamples, software.samples());
        assertEquals(softwareAnisotropy, software.anisotropy());
        assertEquals(preset.equals("auto"), software.viewBudget() != hardware.viewBudget());
    }

    @Test
    void aSettingGoesBeforeTheGraphicsCardsPreset() {
        assertEquals(
                1, choice("samples", 1).settings(Output.DIRECT, false).quality().samples());
    }
}
