package nephele.editor.window.file;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import nephele.editor.file.FileRow;
import nephele.editor.file.RecoveryList;
import nephele.editor.save.journal.RecoverableWork;
import nephele.editor.text.Words;
import nephele.editor.widget.Listeners;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/**
 * The offer to recover lost work: Enter or a double click recovers the selected one, Delete discards it, Esc leaves all
 * for later.
 */
public final class RecoveryPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient RecoveryList lost;
    private final transient Predicate<Words> isAgreed;
    private final transient BooleanSupplier mayLeave;
    private final transient Runnable done;
    private final transient Language language;
    private final PicturedList list;
    private final JButton recover;

    /**
     * @param isAgreed asks a question with yes and no
     * @param mayLeave false if the user wants to stay with the level that is open
     * @param done closes the dialogue
     */
    public RecoveryPanel(
            RecoveryList lost, Language language, Predicate<Words> isAgreed, BooleanSupplier mayLeave, Runnable done) {
        super(new MigLayout("insets 14, fill, wrap 1", "[grow, fill]", "[][grow, fill]14[]"));
        this.lost = lost;
        this.isAgreed = isAgreed;
        this.mayLeave = mayLeave;
        this.done = done;
        this.language = language;
        list = new PicturedList(FileDialogText.LOST_WORK.words(), language, this::picture);
        recover = list.button(FileDialogText.RECOVER, this::recover);
        JButton discard = list.button(FileDialogText.DISCARD, this::discard);
        JButton later = list.button(FileDialogText.LATER, done);
        add(new JLabel(FileDialogText.RECOVER_INTRO.in(language)));
        add(list);
        JPanel buttons = new JPanel(new MigLayout("insets 0", "[]push[][]"));
        buttons.add(discard);
        buttons.add(later);
        buttons.add(recover);
        add(buttons);
        Listeners.onKey(this, "ESCAPE", done);
        Listeners.onKey(list.rowList(), "DELETE", this::discard);
        Listeners.onKey(list.rowList(), "ENTER", this::recover);
        Listeners.onDoubleClick(list.rowList(), this::recover);
        getAccessibleContext().setAccessibleName(FileDialogText.RECOVER_TITLE.in(language));
        list.show(lost.rows());
    }

    /** Returns the list, which has the keyboard first. */
    JComponent rows() {
        return list.rowList();
    }

    /** Returns the button that is the dialogue's default. */
    JButton recoverButton() {
        return recover;
    }

    private void recover() {
        if (list.selected() >= 0 && mayLeave.getAsBoolean()) {
            int index = list.selected();
            done.run();
            lost.recover(index);
        }
    }

    private void discard() {
        int index = list.selected();
        if (index < 0) {
            return;
        }
        FileRow row = lost.rows().get(index);
        Words question = FileDialogText.DISCARD_QUESTION.with(row.title().in(language));
        if (isAgreed.test(question)) {
            lost.discard(index);
            list.show(lost.rows());
            if (lost.works().isEmpty()) {
                done.run();
            }
        }
    }

    private Optional<BufferedImage> picture(int index) {
        RecoverableWork work = lost.works().get(index);
        return work.picture().flatMap(RecoveryPanel::read).or(() -> Optional.of(PicturedList.plan(work.level())));
    }

    private static Optional<BufferedImage> read(Path file) {
        try {
            return Optional.ofNullable(ImageIO.read(file.toFile()));
        } catch (IOException torn) {
            return Optional.empty();
        }
    }
}
