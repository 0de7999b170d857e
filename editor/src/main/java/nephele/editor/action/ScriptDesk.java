package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.text.Words;

/** The surroundings of a script: no user is asked, everything is agreed to, and copied text stays in the session. */
public final class ScriptDesk implements Desk {
    private final Supplier<BufferedImage> picture;
    private final Supplier<Optional<Path>> toOpen;

    /** @param picture draws the whole editor */
    public ScriptDesk(Supplier<BufferedImage> picture) {
        this(picture, Optional::empty);
    }

    /**
     * @param picture draws the whole editor
     * @param toOpen chooses the file to open where a user is asked for one
     */
    public ScriptDesk(Supplier<BufferedImage> picture, Supplier<Optional<Path>> toOpen) {
        this.picture = picture;
        this.toOpen = toOpen;
    }

    @Override
    public Optional<Path> fileToOpen() {
        return toOpen.get();
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
        // The last line ends the script.
    }
}
