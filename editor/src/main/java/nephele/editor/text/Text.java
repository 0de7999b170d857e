package nephele.editor.text;

import nephele.engine.level.Language;

/** A named text, a constant of an enum for each part of the editor; {@code %s} stand for values. */
public interface Text {
    /** Returns the text in all languages, with its placeholders. */
    Words words();

    /** Returns the text in all languages with its {@code %s} replaced, in order, as {@link Words#with}. */
    default Words with(Object... values) {
        return words().with(values);
    }

    /** Returns the text in a language, with its placeholders. */
    default String in(Language language) {
        return words().in(language);
    }
}
