package nephele.editor.panel;

import java.util.List;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import nephele.editor.document.Registration;
import nephele.editor.panel.model.PanelText;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import net.miginfocom.swing.MigLayout;

/** The steps made so far; the selected one is the current state, and a click or an arrow key goes to another. */
public final class HistoryPanel extends JPanel implements AutoCloseable {
    private final transient EditorSession session;
    private final transient Registration registration;
    private final DefaultListModel<String> steps = new DefaultListModel<>();
    private final JList<String> list = new JList<>(steps);
    private boolean isUpdating;

    public HistoryPanel(EditorSession session) {
        super(new MigLayout("insets 4, fill", "[grow, fill]", "[grow, fill]"));
        this.session = session;
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.addListSelectionListener(event -> {
            if (!isUpdating && !event.getValueIsAdjusting() && list.getSelectedIndex() >= 0) {
                session.document().goTo(list.getSelectedIndex());
            }
        });
        add(new JScrollPane(list));
        registration = session.listen(change -> {
            if (change == SessionChange.DOCUMENT || change == SessionChange.SETTINGS || change == SessionChange.FILE) {
                refresh();
            }
        });
        refresh();
    }

    private void refresh() {
        isUpdating = true;
        list.getAccessibleContext().setAccessibleName(PanelText.HISTORY.in(session.language()));
        List<Words> labels = session.document().history().labels();
        show(0, PanelText.START.in(session.language()));
        for (int i = 0; i < labels.size(); i++) {
            show(i + 1, labels.get(i).in(session.language()));
        }
        if (steps.size() > labels.size() + 1) {
            steps.removeRange(labels.size() + 1, steps.size() - 1);
        }
        int position = session.document().history().position();
        if (list.getSelectedIndex() != position) {
            list.setSelectedIndex(position);
            list.ensureIndexIsVisible(position);
        }
        isUpdating = false;
    }

    private void show(int index, String text) {
        if (index >= steps.size()) {
            steps.addElement(text);
        } else if (!steps.get(index).equals(text)) {
            steps.set(index, text);
        }
    }

    @Override
    public void close() {
        registration.close();
    }
}
