package nephele.engine.asset;

import java.io.IOException;

/** A picture that is whole, but of a kind that is not read; the message says which. */
final class UnreadablePicture extends IOException {
    private static final long serialVersionUID = 1;

    private final String remedy;

    UnreadablePicture(String reason, String remedy) {
        super(reason);
        this.remedy = remedy;
    }

    String remedy() {
        return remedy;
    }
}
