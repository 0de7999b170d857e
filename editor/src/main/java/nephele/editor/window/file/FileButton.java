package nephele.editor.window.file;

import javax.swing.JButton;
import nephele.engine.level.Language;

/** The buttons of the dialogues for versions of files. */
final class FileButton {
    private FileButton() {}

    /** Returns a button with a text, by whose constant it is named, that runs an effect. */
    static JButton of(FileDialogText text, Language language, Runnable effect) {
        JButton button = new JButton(text.in(language));
        button.setName(text.name());
        button.addActionListener(event -> effect.run());
        return button;
    }
}
