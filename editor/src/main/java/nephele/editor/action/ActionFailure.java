package nephele.editor.action;

import nephele.editor.text.Words;

/** An action that could not be done; the message is for the user. */
public final class ActionFailure extends Exception {
    private static final long serialVersionUID = 1;

    private final transient Words told;

    public ActionFailure(Words told) {
        super(told.english());
        this.told = told;
    }

    public Words told() {
        return told;
    }
}
