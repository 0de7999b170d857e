package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.text.Words;

/** The surroundings of a script: no user is asked, everything is agreed to, and copied text stays in the session. */
public final class ScriptInterface implements UserInterface {
    private final Supplier<BufferedImage> picture;
    private boolean isEnded;

    /** @param picture draws the whole editor */
    public ScriptInterface(Supplier<BufferedImage> picture) {
        this.picture = picture;
    }

    /** Returns true after the action {@code quit}. */
    public boolean isEnded() {
        return isEnded;
    }

    @Override
    public boolean hasUser() {
        return false;
    }

    @Override
    public Optional<Path> fileToOpen() {
        return Optional.empty();
    }

    @Override
    public Optional<Path> fileToSave() {
        return Optional.empty();
    }

    @Override
    public boolean isAgreed(Words question) {
        return true;
    }

    @Override
    public BufferedImage picture() {
        return picture.get();
    }

    @Override
    public void copy(String text) {
        // The session keeps it; the clipboard of the user's desktop is not a script's.
    }

    @Override
    public String pasted() {
        return "";
    }

    @Override
    public void show(String part) {
        // Nobody looks.
    }

    @Override
    public void quit() {
        isEnded = true;
    }
}
