package nephele.editor.save;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import nephele.engine.level.Language;

/** A message for the user, which names the file and says what to do. */
public record SaveMessage(SaveText text, List<String> values) {
    /** Returns a message with files and reasons in the order of the text's placeholders. */
    public static SaveMessage of(SaveText text, Object... values) {
        return new SaveMessage(text, Arrays.stream(values).map(String::valueOf).toList());
    }

    /** Returns the message in a language. */
    public String in(Language language) {
        return String.format(Locale.ROOT, text.in(language), values.toArray());
    }
}
