package nephele.editor.prove;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.action.Desk;
import nephele.editor.text.Words;

/**
 * The desk of a user who agrees to everything and cancels every choice of a place to save, since saving makes backups
 * in the folders of the user who runs the proof.
 */
final class SilentDesk implements Desk {
    private final Supplier<Path> toOpen;
    private String copied = "";

    /** @param toOpen chooses the next file to open */
    SilentDesk(Supplier<Path> toOpen) {
        this.toOpen = toOpen;
    }

    @Override
    public Optional<Path> fileToOpen() {
        return Optional.of(toOpen.get());
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
        return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    }

    @Override
    public void copy(String text) {
        copied = text;
    }

    @Override
    public String pasted() {
        return copied;
    }

    @Override
    public void show(String part) {
        // There is no window to show it in.
    }

    @Override
    public void quit() {
        // The session goes on.
    }
}
