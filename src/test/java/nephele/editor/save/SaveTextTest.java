package nephele.editor.save;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import nephele.engine.level.Language;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Each message says the same in every language. */
class SaveTextTest {
    @ParameterizedTest
    @EnumSource(SaveText.class)
    void everyLanguageHasTheSamePlaces(SaveText text) {
        int places = text.in(Language.EN).split("%s", -1).length - 1;
        assertTrue(places >= 1);
        Object[] values = Collections.nCopies(places, "50% of C:\\x").toArray();
        for (Language language : Language.values()) {
            String message = SaveMessage.of(text, values).in(language);
            assertEquals(places, message.split("50% of", -1).length - 1, message);
        }
    }
}
