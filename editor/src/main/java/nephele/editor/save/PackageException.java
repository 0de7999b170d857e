package nephele.editor.save;

import nephele.engine.level.Language;

/** Thrown when a package was not written or not opened; nothing of it is left behind. */
public final class PackageException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient SaveMessage told;

    PackageException(SaveMessage message, Throwable cause) {
        super(message.in(Language.EN), cause);
        told = message;
    }

    PackageException(SaveMessage message) {
        this(message, null);
    }

    /** Returns the message for the user: package, entry, reason and remedy. */
    public SaveMessage told() {
        return told;
    }
}
