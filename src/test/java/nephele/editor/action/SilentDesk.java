package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import nephele.editor.text.Words;

/** A desk of tests: agrees to everything, names no files, and keeps what was copied. */
public final class SilentDesk implements Desk {
    private String copied = "";

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
        return new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
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
        throw new IllegalStateException("a script asked for " + part);
    }

    @Override
    public void quit() {
        throw new IllegalStateException("a script asked to quit");
    }
}
