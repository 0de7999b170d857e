package nephele.workshop.prove.editor;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.action.UserInterface;
import nephele.editor.session.EditorSession;
import nephele.editor.start.EditorParts;
import nephele.editor.text.Words;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.dialog.DialogOpener;

/** The ui of an editor without a window: its user agrees to everything, and cancels every choice of a place to save. */
final class StageDesk implements UserInterface {
    private final Map<String, Runnable> parts = new LinkedHashMap<>();
    private final DialogOpener dialogues;
    private final Supplier<Optional<Path>> toOpen;
    private String copied = "";

    /** @param toOpen chooses the next file to open; empty if the user cancels */
    StageDesk(DialogOpener dialogues, Supplier<Optional<Path>> toOpen) {
        this.dialogues = dialogues;
        this.toOpen = toOpen;
    }

    /** Returns the whole editor of a session, with this ui. */
    EditorPanel panel(EditorSession session) {
        return EditorParts.panel(session, this, parts::put, owner -> dialogues);
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
