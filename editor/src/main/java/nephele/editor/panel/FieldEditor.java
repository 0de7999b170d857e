package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordKind;
import nephele.editor.text.EntityWords;
import nephele.editor.text.FieldWords;
import nephele.editor.text.Words;
import nephele.editor.widget.WordCell;
import nephele.engine.level.Exposure;
import nephele.engine.level.TextKind;
import net.miginfocom.swing.MigLayout;

/**
 * The component that shows and changes the value of a field, by its kind.
 *
 * @param show shows a field of the same form; an edit in progress is left alone by equal values
 */
record FieldEditor(JComponent component, Consumer<InspectorField> show) {
    /** The most characters of a refused text that are quoted. */
    private static final int MOST_QUOTED = 24;
    /** A number of stops, and a box that replaces it by the word for automatic. */
    private static final class ExposureEditor {
        private final FieldChanges changes;
        private final JPanel panel = new JPanel(new MigLayout("insets 0, gap 2, fill", "[grow, fill][]", ""));
        private final NumberInput stops;
        private final JCheckBox auto;
        private InspectorField field;

        ExposureEditor(InspectorField field, FieldChanges changes) {
            this.field = field;
            this.changes = changes;
            stops = new NumberInput(this::commit, text -> refuse(changes, text));
            stops.getAccessibleContext().setAccessibleName(field.words().in(changes.language()));
            auto = new JCheckBox(FieldWords.choice(Exposure.AUTO).in(changes.language()));
            auto.addActionListener(event -> changes.set(
                    this.field, auto.isSelected() ? Exposure.AUTO : field.type().freshValue()));
            panel.add(stops, "wmin 30, grow");
            panel.add(auto);
        }

        private boolean commit(double value) {
            return changes.change(field, "inspector " + field.path(), old -> Exposure.ofStops(value));
        }

        private void show(InspectorField next) {
            field = next;
            boolean isAuto = next.value() instanceof Exposure exposure && exposure.isAuto();
            stops.show(
                    next.value() instanceof Exposure exposure ? exposure.fixedStops() : null,
                    isAuto ? "" : placeholder(next, changes));
            auto.setSelected(isAuto);
            auto.putClientProperty(
                    FlatClientProperties.SELECTED_STATE,
                    next.isMixed() ? FlatClientProperties.SELECTED_STATE_INDETERMINATE : null);
        }
    }

    static FieldEditor make(InspectorField field, FieldChanges changes, AssetChooser chooser) {
        return switch (field.type().kind()) {
            case NUMBER, WHOLE -> number(field, changes);
            case VECTOR -> new VectorEditor(field, changes).editor();
            case EXPOSURE -> exposure(field, changes);
            case TRUTH -> truth(field, changes);
            case CHOICE -> combo(field, changes, field.type()::choices, value -> changes.set(field, value));
            case REFERENCE ->
                combo(
                        field,
                        changes,
                        () -> List.copyOf(changes.ids(field.type().refersTo())),
                        value -> changes.set(field, value));
            case VARIANT ->
                combo(
                        field,
                        changes,
                        () -> field.type().kinds().stream()
                                .map(RecordKind::name)
                                .map(Object.class::cast)
                                .toList(),
                        value -> field.type().kinds().stream()
                                .filter(kind -> kind.name().equals(value))
                                .forEach(kind -> changes.withKind(field, kind)));
            case TEXT, ASSET -> new TextEditor(field, changes, isAsset(field) ? chooser : null).editor();
            case RECORD, LIST, TABLE -> heading(changes);
        };
    }

    private static boolean isAsset(InspectorField field) {
        return field.type().kind() == FieldKind.ASSET
                || field.type().field().declaration().text() == TextKind.ASSET;
    }

    static String placeholder(InspectorField field, FieldChanges changes) {
        PanelText text = field.isMixed() ? PanelText.MIXED : PanelText.NOT_SET;
        return text.in(changes.language());
    }

    static void refuse(FieldChanges changes, String text) {
        String start = text.length() > MOST_QUOTED ? text.substring(0, MOST_QUOTED) + "…" : text;
        changes.report(PanelText.NO_NUMBER.with(start));
    }

    private static FieldEditor number(InspectorField field, FieldChanges changes) {
        var input = new NumberInput(
                value -> changes.change(
                        field, "inspector " + field.path(), old -> field.type().number(value)),
                text -> refuse(changes, text));
        return new FieldEditor(
                input,
                next -> input.show(
                        next.value() instanceof Number number ? number.doubleValue() : null,
                        placeholder(next, changes)));
    }

    private static FieldEditor exposure(InspectorField field, FieldChanges changes) {
        var editor = new ExposureEditor(field, changes);
        return new FieldEditor(editor.panel, editor::show);
    }

    private static FieldEditor truth(InspectorField field, FieldChanges changes) {
        var box = new JCheckBox();
        box.addActionListener(event -> changes.set(field, box.isSelected()));
        return new FieldEditor(box, next -> {
            box.setSelected(Boolean.TRUE.equals(next.value()));
            box.putClientProperty(
                    FlatClientProperties.SELECTED_STATE,
                    next.isMixed() ? FlatClientProperties.SELECTED_STATE_INDETERMINATE : null);
            box.setText(next.isMixed() || next.isUnset() ? placeholder(next, changes) : "");
        });
    }

    private static FieldEditor combo(
            InspectorField field, FieldChanges changes, Supplier<List<Object>> choices, Consumer<Object> choose) {
        var combo = new JComboBox<>();
        boolean[] isShowing = {false};
        combo.setRenderer(new WordCell<>(value -> word(field, value).in(changes.language())));
        combo.addActionListener(event -> {
            if (!isShowing[0] && combo.getSelectedItem() != null) {
                choose.accept(combo.getSelectedItem());
            }
        });
        return new FieldEditor(combo, next -> {
            isShowing[0] = true;
            List<Object> all = choices.get();
            if (!all.equals(items(combo))) {
                combo.removeAllItems();
                all.forEach(combo::addItem);
            }
            Object value = next.value() instanceof Record nested && field.type().kind() == FieldKind.VARIANT
                    ? RecordKind.of(nested).name()
                    : next.value();
            if (value != null && !all.contains(value)) {
                combo.addItem(value);
            }
            if (!Objects.equals(combo.getSelectedItem(), value)) {
                combo.setSelectedItem(value);
            }
            combo.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, placeholder(next, changes));
            isShowing[0] = false;
        });
    }

    private static List<Object> items(JComboBox<Object> combo) {
        List<Object> items = new ArrayList<>();
        for (int i = 0; i < combo.getItemCount(); i++) {
            items.add(combo.getItemAt(i));
        }
        return items;
    }

    private static FieldEditor heading(FieldChanges changes) {
        var label = new JLabel();
        return new FieldEditor(label, next -> label.setText(headingText(next, changes)));
    }

    private static String headingText(InspectorField field, FieldChanges changes) {
        if (field.isMixed()) {
            return field.type().kind() == FieldKind.RECORD ? "" : placeholder(field, changes);
        } else if (field.isUnset()) {
            return placeholder(field, changes);
        } else if (field.value() instanceof List<?> list) {
            return PanelText.ENTRIES.with(list.size()).in(changes.language());
        }
        return field.value() instanceof Map<?, ?> table
                ? PanelText.ENTRIES.with(table.size()).in(changes.language())
                : "";
    }

    private static Words word(InspectorField field, Object value) {
        return field.type().kind() == FieldKind.VARIANT ? EntityWords.ofKind((String) value) : FieldWords.choice(value);
    }
}
