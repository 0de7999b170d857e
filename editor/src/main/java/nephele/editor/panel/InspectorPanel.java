package nephele.editor.panel;

import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import nephele.editor.document.Registration;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.InspectorModel;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** The fields of what is selected, or of the level; lines are made again only if other fields are to be shown. */
public final class InspectorPanel extends JPanel implements AutoCloseable {
    private final transient EditorSession session;
    private final transient Registration registration;
    private final transient FieldChanges changes;
    private final transient AssetChooser chooser;
    private final ComparisonPart comparison;
    private final JLabel heading = new JLabel();
    private final JTextArea message = new JTextArea();
    private final JPanel content =
            new WidthTrackingPanel(new MigLayout("insets 4, gap 4 3, fillx, wrap 3", "[][76::, grow, fill][]"));
    private final transient List<FieldLine> lines = new ArrayList<>();
    private transient Language shownLanguage;

    /** @param chooser asked for the name of a picture or mesh */
    public InspectorPanel(EditorSession session, AssetChooser chooser) {
        super(new MigLayout("insets 4, fill, wrap 1, hidemode 3", "[grow, fill]", "[][grow, fill][][]"));
        this.session = session;
        this.chooser = chooser;
        changes = new FieldChanges(session, this::report);
        comparison = new ComparisonPart(session);
        heading.setFont(heading.getFont().deriveFont(Font.BOLD));
        JScrollPane scroll = new JScrollPane(content);
        scroll.getVerticalScrollBar().setUnitIncrement(16);
        add(heading);
        add(scroll);
        message.setEditable(false);
        message.setFocusable(false);
        message.setOpaque(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        // A long message takes lines, not width.
        add(message, "wmin 0");
        add(comparison);
        message.setVisible(false);
        registration = session.listen(change -> {
            if (change == SessionChange.DOCUMENT || change == SessionChange.SETTINGS || change == SessionChange.FILE) {
                refresh();
            }
        });
        refresh();
    }

    private void report(Words words) {
        message.setText(words.in(session.language()));
        message.setVisible(!words.equals(Words.NONE));
    }

    private void refresh() {
        heading.setText(title());
        getAccessibleContext().setAccessibleName(PanelText.INSPECTOR.in(session.language()));
        List<InspectorField> fields = changes.fields();
        if (session.language() == shownLanguage && hasSameForms(fields)) {
            for (int i = 0; i < fields.size(); i++) {
                if (!lines.get(i).field().equals(fields.get(i))) {
                    lines.get(i).show(fields.get(i));
                }
            }
            return;
        }
        shownLanguage = session.language();
        lines.clear();
        content.removeAll();
        for (InspectorField field : fields) {
            FieldLine line = new FieldLine(field, changes, chooser);
            lines.add(line);
            line.addTo(content);
        }
        content.revalidate();
        content.repaint();
    }

    private boolean hasSameForms(List<InspectorField> fields) {
        if (fields.size() != lines.size()) {
            return false;
        }
        for (int i = 0; i < fields.size(); i++) {
            if (!lines.get(i).field().hasSameForm(fields.get(i))) {
                return false;
            }
        }
        return true;
    }

    private String title() {
        List<EntityRef> refs = changes.refs();
        if (refs.equals(InspectorModel.ROOT)) {
            return PanelText.THE_LEVEL.in(session.language());
        }
        return refs.size() == 1
                ? refs.get(0).text()
                : PanelText.MANY_SELECTED.with(refs.size()).in(session.language());
    }

    @Override
    public void close() {
        registration.close();
        comparison.close();
    }
}
