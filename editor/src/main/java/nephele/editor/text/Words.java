package nephele.editor.text;

import java.util.Arrays;
import java.util.Locale;
import nephele.engine.level.Language;

/** A text of the editor in its three languages. */
public record Words(String english, String brazilian, String european) {
    public static final Words NONE = same("");

    /** Returns a text that is the same in all languages: a name, a number, a message of the engine. */
    public static Words same(String text) {
        return new Words(text, text, text);
    }

    public static Words of(String english, String brazilian, String european) {
        return new Words(english, brazilian, european);
    }

    public String in(Language language) {
        return switch (language) {
            case EN -> english;
            case PT_BR -> brazilian;
            case PT_PT -> european;
        };
    }

    /** Returns this text with its {@code %s} replaced, in order; words among the values are put in their language. */
    public Words with(Object... values) {
        return new Words(filled(Language.EN, values), filled(Language.PT_BR, values), filled(Language.PT_PT, values));
    }

    private String filled(Language language, Object... values) {
        Object[] texts = Arrays.stream(values)
                .map(value -> value instanceof Words words ? words.in(language) : value)
                .toArray();
        return String.format(Locale.ROOT, in(language), texts);
    }
}
