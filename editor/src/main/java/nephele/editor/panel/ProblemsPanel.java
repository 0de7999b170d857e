package nephele.editor.panel;

import java.awt.Component;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import javax.swing.SwingWorker;
import javax.swing.Timer;
import nephele.editor.document.Registration;
import nephele.editor.panel.model.PanelText;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import net.miginfocom.swing.MigLayout;

/** The problems of the level, searched a moment after each edit on another thread; with their remedies. */
public final class ProblemsPanel extends JPanel implements AutoCloseable {
    private static final int DELAY_MILLIS = 300;
    /** Searches the problems of a level on another thread, one search at a time; a new one cancels the one before. */
    private static final class ProblemWork {
        private final Consumer<List<LevelProblem>> found;
        private AssetSource assets;
        private ProblemSearch search;
        private Level searched;
        private SwingWorker<Optional<List<LevelProblem>>, Void> running;

        /** @param found receives what was found, on the event dispatch thread */
        ProblemWork(AssetSource assets, Consumer<List<LevelProblem>> found) {
            this.assets = assets;
            this.found = found;
            search = new ProblemSearch(assets);
        }

        /** Returns true if the last search was of another level or other files. */
        boolean isNew(Level level, AssetSource files) {
            return level != searched || files != assets;
        }

        void search(Level level, AssetSource files) {
            if (running != null) {
                running.cancel(false);
            }
            if (files != assets) {
                assets = files;
                search = new ProblemSearch(files);
            }
            searched = level;
            ProblemSearch used = search;
            running = new SwingWorker<>() {
                @Override
                protected Optional<List<LevelProblem>> doInBackground() {
                    // The search keeps what it has found, so that two at a time would meet in it.
                    synchronized (used) {
                        return used.find(level, this::isCancelled);
                    }
                }

                @Override
                protected void done() {
                    try {
                        if (!isCancelled()) {
                            get().ifPresent(found);
                        }
                    } catch (CancellationException | InterruptedException cancelled) {
                        // The next search tells the result.
                    } catch (ExecutionException failed) {
                        throw new IllegalStateException("the search for problems failed", failed.getCause());
                    }
                }
            };
            running.execute();
        }
    }

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
        list.setCellRenderer(cells());
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
            if (change == SessionChange.VIEW || change == SessionChange.DOCUMENT) {
                followChosen();
            }
            if (change == SessionChange.SETTINGS) {
                translate();
            } else if (change != SessionChange.STATUS && !session.document().isDragging()) {
                restart();
            }
        });
        translate();
        restart();
    }

    private ListCellRenderer<Object> cells() {
        return new DefaultListCellRenderer() {
            @Override
            public Component getListCellRendererComponent(
                    JList<?> any, Object value, int index, boolean isSelected, boolean hasFocus) {
                super.getListCellRendererComponent(any, "", index, isSelected, hasFocus);
                LevelProblem problem = (LevelProblem) value;
                String place = problem.entity() == null
                        ? problem.path()
                        : problem.entity().text();
                setText(problem.message().in(session.language()) + "  –  " + place);
                setToolTipText(getText());
                PanelText severity =
                        switch (problem.severity()) {
                            case ERROR -> PanelText.ERROR;
                            case WARNING -> PanelText.WARNING;
                            case HINT -> PanelText.HINT;
                        };
                setIcon(
                        switch (problem.severity()) {
                            case ERROR -> PanelIcon.ERROR;
                            case WARNING -> PanelIcon.WARNING;
                            case HINT -> PanelIcon.HINT;
                        });
                getAccessibleContext().setAccessibleName(severity.in(session.language()) + ": " + getText());
                return this;
            }
        };
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
        List<LevelProblem.Fix> fixes = selected == null ? List.of() : selected.fixes();
        Language language = session.language();
        String text = PanelText.FIX.in(language);
        fix.setText(fixes.size() == 1 ? fixes.get(0).label().in(language) : fixes.isEmpty() ? text : text + " …");
        fix.setEnabled(!fixes.isEmpty());
        hide.setEnabled(selected != null);
    }

    /** Repairs at once where there is one way; otherwise the user chooses. */
    private void fixSelected() {
        List<LevelProblem.Fix> fixes = list.getSelectedValue().fixes();
        if (fixes.size() == 1) {
            apply(fixes.get(0));
            return;
        }
        JPopupMenu menu = new JPopupMenu();
        for (LevelProblem.Fix remedy : fixes) {
            menu.add(remedy.label().in(session.language())).addActionListener(event -> apply(remedy));
        }
        menu.show(fix, 0, fix.getHeight());
    }

    private void apply(LevelProblem.Fix remedy) {
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
