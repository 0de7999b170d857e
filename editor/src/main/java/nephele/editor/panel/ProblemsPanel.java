package nephele.editor.panel;

import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import nephele.editor.document.Registration;
import nephele.editor.panel.model.PanelText;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemFix;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionListener.Change;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The problems of the level, searched a moment after each edit on another thread; with their remedies. */
public final class ProblemsPanel extends JPanel implements AutoCloseable {
    private static final int DELAY_MILLIS = 300;

    private final transient EditorSession session;
    private final transient Registration registration;
    private final transient ProblemWork work;
    private final DefaultListModel<LevelProblem> problems = new DefaultListModel<>();
    private final JList<LevelProblem> list = new JList<>(problems);
    private final JLabel state = new JLabel();
    private final JButton fix = new JButton();
    private final JButton hide = new JButton();
    private final Timer debounce;
    private boolean isUpdating;

    /** @param choose called with the problem that was selected: its marks are to be shown, its entity selected */
    public ProblemsPanel(EditorSession session, Consumer<LevelProblem> choose) {
        super(new MigLayout("insets 4, fill, wrap 1", "[grow, fill]", "[grow, fill][]"));
        this.session = session;
        work = new ProblemWork(session.assets(), this::show);
        debounce =
                new Timer(DELAY_MILLIS, event -> work.search(session.document().level(), session.assets()));
        debounce.setRepeats(false);
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new ProblemCell(session));
        list.addListSelectionListener(event -> {
            enableButtons();
            if (!isUpdating && !event.getValueIsAdjusting() && list.getSelectedValue() != null) {
                choose.accept(list.getSelectedValue());
            }
        });
        fix.addActionListener(event -> fixSelected());
        hide.addActionListener(event -> hideSelected());
        JPanel buttons = new JPanel(new MigLayout("insets 0", "[grow][][]"));
        buttons.add(state);
        buttons.add(fix);
        buttons.add(hide);
        add(new JScrollPane(list));
        add(buttons);
        registration = session.listen(change -> {
            if (change == Change.VIEW || change == Change.DOCUMENT) {
                followChosen();
            }
            if (change == Change.SETTINGS) {
                translate();
            } else if (change != Change.STATUS && !session.document().isDragging()) {
                restart();
            }
        });
        translate();
        restart();
    }

    private void restart() {
        if (work.isNew(session.document().level(), session.assets())) {
            state.setText(PanelText.SEARCHING.in(session.language()) + " …");
            debounce.restart();
        }
    }

    /** Shows the problems that a search has found. */
    public void show(List<LevelProblem> found) {
        LevelProblem before = list.getSelectedValue();
        isUpdating = true;
        problems.clear();
        for (LevelProblem problem : found) {
            if (!LevelProblem.isHidden(session.document().level(), problem)) {
                problems.addElement(problem);
                if (before != null && before.key().equals(problem.key())) {
                    list.setSelectedIndex(problems.size() - 1);
                }
            }
        }
        isUpdating = false;
        translate();
        boolean isPresent = !work.isNew(session.document().level(), session.assets());
        if (isPresent && SwingUtilities.getWindowAncestor(this) != null) {
            session.proving().problems().found(found);
        }
    }

    /** Selects the problem whose place is marked, which keys choose, too. */
    private void followChosen() {
        LevelProblem chosen = session.proving().problems().chosen().orElse(null);
        isUpdating = true;
        if (chosen == null) {
            list.clearSelection();
        } else if (!chosen.equals(list.getSelectedValue())) {
            list.setSelectedValue(chosen, true);
        }
        isUpdating = false;
    }

    private void translate() {
        Language language = session.language();
        list.getAccessibleContext().setAccessibleName(PanelText.PROBLEMS.in(language));
        hide.setText(PanelText.HIDE.in(language));
        state.setText(
                problems.isEmpty()
                        ? PanelText.NO_PROBLEMS.in(language)
                        : PanelText.PROBLEMS.in(language) + ": " + problems.size());
        enableButtons();
        list.repaint();
    }

    private void enableButtons() {
        LevelProblem selected = list.getSelectedValue();
        List<ProblemFix> fixes = selected == null ? List.of() : selected.fixes();
        Language language = session.language();
        String text = PanelText.FIX.in(language);
        fix.setText(fixes.size() == 1 ? fixes.get(0).label().in(language) : fixes.isEmpty() ? text : text + " …");
        fix.setEnabled(!fixes.isEmpty());
        hide.setEnabled(selected != null);
    }

    /** Repairs at once where there is one way; otherwise the user chooses. */
    private void fixSelected() {
        List<ProblemFix> fixes = list.getSelectedValue().fixes();
        if (fixes.size() == 1) {
            apply(fixes.get(0));
            return;
        }
        JPopupMenu menu = new JPopupMenu();
        for (ProblemFix remedy : fixes) {
            menu.add(remedy.label().in(session.language())).addActionListener(event -> apply(remedy));
        }
        menu.show(fix, 0, fix.getHeight());
    }

    private void apply(ProblemFix remedy) {
        keepKeyboard();
        session.document().edit(remedy.label(), remedy.change());
    }

    private void hideSelected() {
        LevelProblem selected = list.getSelectedValue();
        keepKeyboard();
        session.document().edit(PanelText.HIDE_PROBLEM.words(), level -> LevelProblem.hide(level, selected));
    }

    /** A button that is disabled while it has the keyboard would pass it on to a field of the inspector. */
    private void keepKeyboard() {
        list.requestFocusInWindow();
    }

    @Override
    public void close() {
        debounce.stop();
        registration.close();
    }
}
