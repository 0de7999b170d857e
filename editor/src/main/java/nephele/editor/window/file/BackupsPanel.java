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
import nephele.editor.widget.Listeners;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The previous versions of the open file: Enter or a double click restores the selected one, Esc closes. */
public final class BackupsPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient BackupList backups;
    private final transient BooleanSupplier mayLeave;
    private final transient Consumer<Words> refused;
    private final transient Runnable done;
    private final PicturedList list;
    private final JButton restore;

    /**
     * @param mayLeave false if the user wants to stay with the level that is open
     * @param refused receives what could not be done
     * @param done closes the dialogue
     */
    public BackupsPanel(
            BackupList backups, Language language, BooleanSupplier mayLeave, Consumer<Words> refused, Runnable done) {
        super(new MigLayout("insets 14, fill, wrap 1", "[grow, fill]", "[][grow, fill]14[]"));
        this.backups = backups;
        this.mayLeave = mayLeave;
        this.refused = refused;
        this.done = done;
        list = new PicturedList(FileDialogText.VERSIONS.words(), language, this::picture);
        restore = list.button(FileDialogText.RESTORE, this::restore);
        JButton copy = list.button(FileDialogText.OPEN_COPY, this::openCopy);
        boolean isEmpty = backups.rows().isEmpty();
        restore.setEnabled(!isEmpty);
        copy.setEnabled(!isEmpty);
        add(new JLabel((isEmpty ? FileDialogText.NO_BACKUPS : FileDialogText.BACKUPS_INTRO).in(language)));
        add(list);
        JPanel buttons = new JPanel(new MigLayout("insets 0", "push[][][]"));
        buttons.add(list.button(FileDialogText.CLOSE, done));
        buttons.add(copy);
        buttons.add(restore);
        add(buttons);
        Listeners.onKey(this, "ESCAPE", done);
        Listeners.onKey(list.rowList(), "ENTER", this::restore);
        Listeners.onDoubleClick(list.rowList(), this::restore);
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
        take(false);
    }

    private void openCopy() {
        if (mayLeave.getAsBoolean()) {
            take(true);
        }
    }

    private void take(boolean asCopy) {
        int index = list.selected();
        if (index < 0) {
            return;
        }
        try {
            if (asCopy) {
                backups.openCopy(index);
            } else {
                backups.restore(index);
            }
            done.run();
        } catch (EditorRefusal refusal) {
            refused.accept(refusal.words());
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
