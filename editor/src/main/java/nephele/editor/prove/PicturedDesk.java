package nephele.editor.prove;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import nephele.editor.action.Desk;
import nephele.editor.start.EditorSurroundings;
import nephele.editor.text.Words;
import nephele.editor.window.dialog.DialogFrame;

/** The desk of an editor of which pictures are taken: it keeps what a dialogue would show, and never asks. */
final class PicturedDesk implements Desk {
    private final Map<String, Runnable> parts = new LinkedHashMap<>();
    private DialogFrame.Content opened;
    private String copied = "";

    /** Returns what connects an editor with this desk. */
    EditorSurroundings surroundings() {
        Function<Component, nephele.editor.window.dialog.DialogOpener> dialogues =
                owner -> (title, making) -> opened = making.apply(() -> {});
        return new EditorSurroundings(this, parts::put, dialogues);
    }

    /** Shows a part; returns what its dialogue holds, if it is one that can be used now. */
    Optional<DialogFrame.Content> dialogue(String part) {
        opened = null;
        show(part);
        return Optional.ofNullable(opened);
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
        Optional.ofNullable(parts.get(part)).ifPresent(Runnable::run);
    }

    @Override
    public void quit() {
        // The session goes on.
    }
}
