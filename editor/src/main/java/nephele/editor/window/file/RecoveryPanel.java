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
import nephele.editor.widget.ComponentKeys;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/**
 * The offer to recover lost work: Enter or a double click recovers the selected one, Delete discards it, Esc leaves all
 * for later.
 */
public final class RecoveryPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient RecoveryList lost;
    private final transient Answers answers;
    private final transient Language language;
    private final PicturedList list;
    private final JButton recover;

    /**
     * The services that the dialogue gives its panel.
     *
     * @param isAgreed asks a question with yes and no
     * @param mayLeave false if the user wants to stay with the level that is open
     * @param done closes the dialogue
     */
    public record Answers(Predicate<Words> isAgreed, BooleanSupplier mayLeave, Runnable done) {}

    public RecoveryPanel(RecoveryList lost, Language language, Answers answers) {
        super(new MigLayout("insets 14, fill, wrap 1", "[grow, fill]", "[][grow, fill]14[]"));
        this.lost = lost;
        this.answers = answers;
        this.language = language;
        list = new PicturedList(FileDialogText.LOST_WORK.words(), language, this::picture);
        recover = FileButton.of(FileDialogText.RECOVER, language, this::recover);
        JButton discard = FileButton.of(FileDialogText.DISCARD, language, this::discard);
        JButton later = FileButton.of(FileDialogText.LATER, language, answers.done());
        add(new JLabel(FileDialogText.RECOVER_INTRO.in(language)));
        add(list);
        JPanel buttons = new JPanel(new MigLayout("insets 0", "[]push[][]"));
        buttons.add(discard);
        buttons.add(later);
        buttons.add(recover);
        add(buttons);
        ComponentKeys.bind(this, "ESCAPE", answers.done());
        ComponentKeys.bind(list.rowList(), "DELETE", this::discard);
        ComponentKeys.bind(list.rowList(), "ENTER", this::recover);
        DoubleClick.on(list.rowList(), this::recover);
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
        if (list.selected() >= 0 && answers.mayLeave().getAsBoolean()) {
            int index = list.selected();
            answers.done().run();
            lost.recover(index);
        }
    }

    private void discard() {
        int index = list.selected();
        if (index < 0) {
            return;
        }
        FileRow row = lost.rows().get(index);
        Words question =
                FileDialogText.DISCARD_QUESTION.words().with(row.title().in(language));
        if (answers.isAgreed().test(question)) {
            lost.discard(index);
            list.show(lost.rows());
            if (lost.works().isEmpty()) {
                answers.done().run();
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
