package nephele.editor.prove;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.action.Desk;
import nephele.editor.text.Words;

/** The desk of a user who agrees to everything, and cancels every choice of a place to save. */
final class SilentDesk implements Desk {
    private final Supplier<Path> toOpen;
    private final Map<String, Runnable> parts = new HashMap<>();
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

    /** Registers what shows a part; the last one of a name counts. */
    void part(String name, Runnable opener) {
        parts.put(name, opener);
    }

    @Override
    public void show(String part) {
        Optional.ofNullable(parts.get(part)).ifPresent(Runnable::run);
    }

    @Override
    public boolean asks(String action) {
        boolean isAsked = parts.containsKey(action);
        show(action);
        return isAsked;
    }

    @Override
    public void quit() {
        // The session goes on.
    }
}
