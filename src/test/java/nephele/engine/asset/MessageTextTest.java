package nephele.engine.asset;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MessageTextTest {
    /** Names are spelled as their authors spell them; what steers a terminal, or shows nothing, is not passed on. */
    @ParameterizedTest
    @CsvSource({
        "peça.bin, peça.bin",
        "中文.png, 中文.png",
        "a\u001b[31mb, a?[31mb",
        "a\u202eb, a?b",
        "a\u0000b, a?b",
        "\ud800x, ?x",
        "😀.obj, 😀.obj"
    })
    void namesAreSpelledAsTheyAre(String text, String shown) {
        assertEquals(shown, MessageText.printable(text));
    }

    @Test
    void theRuleOfAssetIdsSpellsItsCharacter() {
        assertEquals("character 'ç' (U+00E7) is not allowed in an asset id", AssetId.rejectionReason("peça.bin"));
        assertEquals("character '😀' (U+1F600) is not allowed in an asset id", AssetId.rejectionReason("😀.obj"));
    }
}
