package nephele.editor.start;

import java.awt.Component;
import java.util.function.BiConsumer;
import java.util.function.Function;
import nephele.editor.action.Desk;
import nephele.editor.window.dialog.DialogOpener;

/**
 * What an editor's panel is connected with.
 *
 * @param parts receives the name of each part that can be shown, and what opens it
 * @param dialogues returns what shows dialogues over the window of a component
 */
public record EditorSurroundings(
        Desk desk, BiConsumer<String, Runnable> parts, Function<Component, DialogOpener> dialogues) {}
