package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.text.ChoiceWord;
import nephele.engine.level.Exposure;
import net.miginfocom.swing.MigLayout;

/** A number of stops, and a box that replaces it by the word for automatic. */
final class ExposureEditor implements FieldEditor {
    private final FieldChanges changes;
    private final JPanel panel = new JPanel(new MigLayout("insets 0, gap 2, fill", "[grow, fill][]", ""));
    private final NumberInput stops;
    private final JCheckBox auto;
    private InspectorField field;

    ExposureEditor(InspectorField field, FieldChanges changes) {
        this.field = field;
        this.changes = changes;
        stops = new NumberInput(this::commit, text -> FieldEditors.refuse(changes, text));
        stops.getAccessibleContext().setAccessibleName(field.words().in(changes.language()));
        auto = new JCheckBox(ChoiceWord.words(Exposure.AUTO).in(changes.language()));
        auto.addActionListener(event -> changes.set(
                this.field, auto.isSelected() ? Exposure.AUTO : field.type().freshValue()));
        panel.add(stops, "wmin 30, grow");
        panel.add(auto);
    }

    private boolean commit(double value) {
        return changes.change(field, "inspector " + field.path(), old -> Exposure.ofStops(value));
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void show(InspectorField next) {
        field = next;
        boolean isAuto = next.value() instanceof Exposure exposure && exposure.isAuto();
        stops.show(
                next.value() instanceof Exposure exposure ? exposure.fixedStops() : null,
                isAuto ? "" : FieldEditors.placeholder(next, changes));
        auto.setSelected(isAuto);
        auto.putClientProperty(
                FlatClientProperties.SELECTED_STATE,
                next.isMixed() ? FlatClientProperties.SELECTED_STATE_INDETERMINATE : null);
    }
}
