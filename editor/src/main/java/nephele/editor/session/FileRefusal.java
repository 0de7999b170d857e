package nephele.editor.session;

import nephele.editor.text.Words;

/** Thrown when a file can't be opened, imported or added; the message is for the user, and nothing has changed. */
public final class FileRefusal extends Exception {
    private static final long serialVersionUID = 1;

    private final transient Words told;

    public FileRefusal(Words told) {
        super(told.english());
        this.told = told;
    }

    public Words told() {
        return told;
    }
}
