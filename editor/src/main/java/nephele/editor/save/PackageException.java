package nephele.editor.save;

import nephele.editor.text.Words;

/** Thrown when a package was not written or not opened; nothing of it is left behind. */
public final class PackageException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient Words told;

    PackageException(Words message, Throwable cause) {
        super(message.english(), cause);
        told = message;
    }

    PackageException(Words message) {
        this(message, null);
    }

    /** Returns the message for the user: package, entry, reason and remedy. */
    public Words told() {
        return told;
    }
}
