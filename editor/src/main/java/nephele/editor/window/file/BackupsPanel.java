package nephele.editor.window.file;

import com.formdev.flatlaf.util.UIScale;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import nephele.editor.file.BackupList;
import nephele.editor.session.FileRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The previous versions of the open file: Enter or a double click restores the selected one, Esc closes. */
public final class BackupsPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient BackupList backups;
    private final transient Language language;
    private final transient Answers answers;
    private final PicturedList list;
    private final JButton restore;

    /**
     * What the panel needs of its dialogue.
     *
     * @param mayLeave false if the user wants to stay with the level that is open
     * @param tell receives what could not be done
     * @param done closes the dialogue
     */
    public record Answers(BooleanSupplier mayLeave, Consumer<Words> tell, Runnable done) {}

    /** Something that is done with the version of a row. */
    @FunctionalInterface
    private interface Effect {
        void on(int index) throws FileRefusal;
    }

    public BackupsPanel(BackupList backups, Language language, Answers answers) {
        super(new MigLayout("insets 14, fill, wrap 1", "[grow, fill]", "[][grow, fill]14[]"));
        this.backups = backups;
        this.language = language;
        this.answers = answers;
        list = new PicturedList(FileDialogText.VERSIONS.words(), language, this::picture);
        restore = button(FileDialogText.RESTORE, this::restore);
        JButton copy = button(FileDialogText.OPEN_COPY, this::openCopy);
        boolean isEmpty = backups.rows().isEmpty();
        restore.setEnabled(!isEmpty);
        copy.setEnabled(!isEmpty);
        add(new JLabel((isEmpty ? FileDialogText.NO_BACKUPS : FileDialogText.BACKUPS_INTRO).in(language)));
        add(list);
        JPanel buttons = new JPanel(new MigLayout("insets 0", "push[][][]"));
        buttons.add(button(FileDialogText.CLOSE, answers.done()));
        buttons.add(copy);
        buttons.add(restore);
        add(buttons);
        DialogueKeys.bind(this, "ESCAPE", answers.done());
        DialogueKeys.bind(list.rowList(), "ENTER", this::restore);
        DoubleClick.on(list.rowList(), this::restore);
        list.show(backups.rows());
    }

    private JButton button(FileDialogText text, Runnable effect) {
        JButton button = new JButton(text.in(language));
        button.setName(text.name());
        button.addActionListener(event -> effect.run());
        return button;
    }

    /** Returns the list, which has the keyboard first. */
    JComponent rows() {
        return list.rowList();
    }

    /** Returns the button that is the dialogue's default. */
    JButton restoreButton() {
        return restore;
    }

    private void restore() {
        act(backups::restore);
    }

    private void openCopy() {
        if (answers.mayLeave().getAsBoolean()) {
            act(backups::openCopy);
        }
    }

    private void act(Effect effect) {
        if (list.selected() < 0) {
            return;
        }
        try {
            effect.on(list.selected());
            answers.done().run();
        } catch (FileRefusal refusal) {
            answers.tell().accept(refusal.told());
        }
    }

    private Optional<BufferedImage> picture(int index) {
        try {
            return Optional.of(PlanPicture.of(
                    backups.level(index),
                    UIScale.scale(PicturedList.PICTURE_WIDTH),
                    UIScale.scale(PicturedList.PICTURE_HEIGHT)));
        } catch (FileRefusal unreadable) {
            return Optional.empty();
        }
    }
}
