package nephele.editor.panel.model;

import nephele.engine.level.json.WordFormats;

/** The word for a constant or a key of a table, as files have it. */
public final class ChoiceWord {
    private ChoiceWord() {}

    /** Returns the word. */
    public static String of(Object value) {
        return value instanceof Enum<?> ? WordFormats.Choice.word(value) : String.valueOf(value);
    }
}
