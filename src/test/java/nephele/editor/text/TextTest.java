package nephele.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.parallel.ExecutionMode.CONCURRENT;

import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import nephele.editor.brush.BrushText;
import nephele.editor.panel.model.PanelText;
import nephele.editor.play.PlayText;
import nephele.editor.problem.ProblemText;
import nephele.editor.proving.HeatText;
import nephele.editor.save.SaveText;
import nephele.editor.window.WindowText;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each text says the same in every language. */
@Execution(CONCURRENT)
class TextTest {
    private static final String VALUE = "50% of C:\\x";

    static Stream<Text> texts() {
        List<Text[]> topics = List.of(
                BrushText.values(),
                HeatText.values(),
                PanelText.values(),
                PlayText.values(),
                ProblemText.values(),
                SaveText.values(),
                WindowText.values());
        return topics.stream().flatMap(Stream::of);
    }

    private static int places(String text, String placeholder) {
        return text.split(java.util.regex.Pattern.quote(placeholder), -1).length - 1;
    }

    @ParameterizedTest
    @MethodSource("texts")
    void everyLanguageHasTheSamePlaces(Text text) {
        int places = places(text.words().english(), "%s");
        Words filled = text.with(Collections.nCopies(places, VALUE).toArray());
        for (Language language : Language.values()) {
            assertFalse(text.in(language).isBlank());
            assertEquals(places, places(filled.in(language), VALUE), filled.in(language));
        }
    }

    @Test
    void wordsInAPlaceAreInTheLanguageOfTheText() {
        Words filled = Words.of("%s, %s", "%s e %s", "%s; %s").with(Words.of("one", "um", "dois"), 2);
        assertEquals(Words.of("one, 2", "um e 2", "dois; 2"), filled);
    }
}
