package nephele.editor.window.file;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import nephele.editor.file.BackupList;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.widget.ComponentKeys;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The previous versions of the open file: Enter or a double click restores the selected one, Esc closes. */
public final class BackupsPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient BackupList backups;
    private final transient Answers answers;
    private final PicturedList list;
    private final JButton restore;

    /**
     * The services that the dialogue gives its panel.
     *
     * @param mayLeave false if the user wants to stay with the level that is open
     * @param tell receives what could not be done
     * @param done closes the dialogue
     */
    public record Answers(BooleanSupplier mayLeave, Consumer<Words> tell, Runnable done) {}

    /** Something that is done with the version of a row. */
    @FunctionalInterface
    private interface Effect {
        void on(int index) throws EditorRefusal;
    }

    public BackupsPanel(BackupList backups, Language language, Answers answers) {
        super(new MigLayout("insets 14, fill, wrap 1", "[grow, fill]", "[][grow, fill]14[]"));
        this.backups = backups;
        this.answers = answers;
        list = new PicturedList(FileDialogText.VERSIONS.words(), language, this::picture);
        restore = FileButton.of(FileDialogText.RESTORE, language, this::restore);
        JButton copy = FileButton.of(FileDialogText.OPEN_COPY, language, this::openCopy);
        boolean isEmpty = backups.rows().isEmpty();
        restore.setEnabled(!isEmpty);
        copy.setEnabled(!isEmpty);
        add(new JLabel((isEmpty ? FileDialogText.NO_BACKUPS : FileDialogText.BACKUPS_INTRO).in(language)));
        add(list);
        JPanel buttons = new JPanel(new MigLayout("insets 0", "push[][][]"));
        buttons.add(FileButton.of(FileDialogText.CLOSE, language, answers.done()));
        buttons.add(copy);
        buttons.add(restore);
        add(buttons);
        ComponentKeys.bind(this, "ESCAPE", answers.done());
        ComponentKeys.bind(list.rowList(), "ENTER", this::restore);
        DoubleClick.on(list.rowList(), this::restore);
        list.show(backups.rows());
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
        } catch (EditorRefusal refusal) {
            answers.tell().accept(refusal.words());
        }
    }

    private Optional<BufferedImage> picture(int index) {
        try {
            return Optional.of(PicturedList.plan(backups.level(index)));
        } catch (EditorRefusal unreadable) {
            return Optional.empty();
        }
    }
}
