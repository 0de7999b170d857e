package nephele.editor.action;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import nephele.editor.file.DroppedFile.SceneUse;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;

/** The services that an action requests: a window answers with dialogues, a script without a user. */
public interface UserInterface {
    /** Returns false in a script, where nobody can be asked and nothing is shown. */
    default boolean hasUser() {
        return true;
    }

    /** Asks for a level file to open; empty if the user cancels. */
    Optional<Path> fileToOpen();

    /** Asks where to save; empty if the user cancels. */
    Optional<Path> fileToSave();

    /** Asks where to write a package; empty if the user cancels. */
    default Optional<Path> fileToExport() {
        return Optional.empty();
    }

    /** Asks for a file to add to the level; empty if the user cancels. */
    default Optional<Path> fileToAdd() {
        return Optional.empty();
    }

    /** Tells of a problem and offers a remedy; false if the user declines. A script has nobody to tell. */
    default boolean isRemedied(Words problem, Words remedy) {
        return false;
    }

    /** Asks what to do with a scene that is added to an open level; empty if the user cancels. A script inserts it. */
    default Optional<SceneUse> sceneUse(Path scene) {
        return Optional.of(SceneUse.INSERT);
    }

    /** Asks a question with yes and no; a script's answer is yes. */
    boolean isAgreed(Words question);

    /** Returns the picture of the whole editor. */
    BufferedImage picture() throws EditorRefusal;

    /** Puts text where other programs can paste it. */
    void copy(String text);

    /** Returns the text that was copied last, here or in another program; empty for none. */
    String pasted();

    /** Shows a part of the window by its name, such as {@code palette} or {@code guide}; a script ignores it. */
    void show(String part);

    /** Opens the dialogue that asks for the values of an action; false if there is none, as in a script. */
    default boolean asks(String action) {
        return false;
    }

    /** Ends the editor if the user agrees to lose nothing. */
    void quit();
}
