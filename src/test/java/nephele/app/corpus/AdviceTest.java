package nephele.app.corpus;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.function.Function;
import java.util.regex.Pattern;
import nephele.engine.asset.AssetId;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.ModelFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What messages advise can be done, and the names in them are spelt as in the file. */
class AdviceTest {
    private static final Pattern EMPTY_RANGE =
            Pattern.compile("\\b0 to -1\\b|\\b1 to 0\\b|(one of|there are):? *(;|$)");

    @ParameterizedTest
    @CsvSource({
        "a.obj, f 1 2 3",
        "a.obj, f -1 -2 -3",
        "a.obj, v 0 0 0|v 1 0 0|v 0 1 0|f 1/1 2/2 3/3",
        "a.obj, v 0 0 0|v 1 0 0|v 0 1 0|f 1//1 2//2 3//3",
        "a.3d, 0|0|0|0",
        "a.3d, 3|0 0 0|1 0 0|0 1 0||||0 1 9"
    })
    void noRangeIsEmpty(String file, String lines) {
        byte[] bytes = lines.replace('|', '\n').getBytes(StandardCharsets.UTF_8);
        var refused = assertThrows(ModelFileException.class, () -> ModelFiles.read(file, bytes, NOTHING));
        assertFalse(EMPTY_RANGE.matcher(refused.getMessage()).find(), refused.getMessage());
    }

    private static final Function<String, byte[]> NOTHING = name -> null;

    @Test
    void namesThatAreNotAllowedAreSpeltRight() {
        String objection = AssetId.rejectionReason("peça.png");
        assertTrue(objection.contains("'ç' (U+00E7) is not allowed"), objection);
        String escape = AssetId.rejectionReason("a\u001bb.png");
        assertTrue(escape.contains("character U+001B is not allowed"), escape);
        String level = "{\"format\": \"nephele-level\", \"version\": 1, \"çedilha\": 1, \"a\u202eb\": 2}";
        var refused = assertThrows(
                LevelFormatException.class, () -> LevelJson.read("l", level.getBytes(StandardCharsets.UTF_8)));
        assertTrue(
                refused.getMessage().contains("çedilha") && refused.getMessage().contains("a?b"));
    }
}
