package nephele.editor.text;

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

    /** Returns this text with its {@code %s} replaced, in order; words are put in each in its own language. */
    public Words with(Object... arguments) {
        return new Words(
                filled(Language.EN, arguments), filled(Language.PT_BR, arguments), filled(Language.PT_PT, arguments));
    }

    private String filled(Language language, Object... arguments) {
        Object[] values = new Object[arguments.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = arguments[i] instanceof Words words ? words.in(language) : arguments[i];
        }
        return String.format(in(language), values);
    }
}
