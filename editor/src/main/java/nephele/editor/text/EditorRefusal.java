package nephele.editor.text;

/** Thrown when something can't be done; the words are for the user, and nothing has changed. */
public final class EditorRefusal extends Exception {
    private static final long serialVersionUID = 1;

    private final transient Words words;

    public EditorRefusal(Words words) {
        this(words, null);
    }

    public EditorRefusal(Words words, Throwable cause) {
        super(words.english(), cause);
        this.words = words;
    }

    /** Returns the reason, and the remedy if there is one. */
    public Words words() {
        return words;
    }
}
