package nephele.engine.level.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Only a file without a character is called empty. */
class CutJsonTest {
    @ParameterizedTest
    @CsvSource(
            value = {"'',true", "' ',true", "{,false", "[,false", "{\"format\",false", "{\"format\":,false"},
            ignoreLeadingAndTrailingWhitespace = false)
    void aFileThatEndsTooEarlyIsNotCalledEmpty(String text, boolean isEmpty) {
        String said = assertThrows(
                        LevelFormatException.class,
                        () -> LevelJson.read("cut.json", text.getBytes(StandardCharsets.UTF_8)))
                .getMessage();
        assertEquals(isEmpty, said.contains("is empty"), said);
        assertEquals(!isEmpty, said.contains("ends too early"), said);
    }
}
