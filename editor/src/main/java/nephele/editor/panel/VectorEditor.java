package nephele.editor.panel;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JColorChooser;
import javax.swing.JPanel;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.PanelText;
import nephele.engine.math.Vec3;
import net.miginfocom.swing.MigLayout;

/** Three numbers, with a swatch if they are a linear RGB colour. */
final class VectorEditor {
    private static final List<ToDoubleFunction<Vec3>> AXES = List.of(Vec3::x, Vec3::y, Vec3::z);

    private final FieldChanges changes;
    private final JPanel panel = new JPanel(new MigLayout("insets 0, gap 2, fill", "[grow, fill, sg]", ""));
    private final List<NumberInput> inputs = new ArrayList<>();
    private final JButton swatch = new JButton();
    private InspectorField field;

    VectorEditor(InspectorField field, FieldChanges changes) {
        this.field = field;
        this.changes = changes;
        boolean isColour = field.type().isColour();
        for (int axis = 0; axis < 3; axis++) {
            int changed = axis;
            var input = new NumberInput(value -> commit(changed, value), text -> FieldEditor.refuse(changes, text));
            input.getAccessibleContext()
                    .setAccessibleName(
                            field.words().in(changes.language()) + " " + (isColour ? "RGB" : "xyz").charAt(axis));
            inputs.add(input);
            panel.add(input, "wmin 30, grow");
        }
        if (isColour) {
            panel.add(swatch, "wmax pref, grow 0");
            swatch.addActionListener(event -> choose());
            swatch.getAccessibleContext()
                    .setAccessibleName(PanelText.CHOOSE_COLOUR
                            .with(field.words().in(changes.language()))
                            .in(changes.language()));
        }
    }

    private boolean commit(int axis, double value) {
        return changes.change(field, "inspector " + field.path() + axis, old -> with((Vec3) old, axis, value));
    }

    private static Vec3 with(Vec3 old, int axis, double value) {
        Vec3 v = old == null ? Vec3.ZERO : old;
        return new Vec3(axis == 0 ? value : v.x(), axis == 1 ? value : v.y(), axis == 2 ? value : v.z());
    }

    private void choose() {
        Vec3 before = field.value() instanceof Vec3 value ? value : new Vec3(1, 1, 1);
        Color chosen =
                JColorChooser.showDialog(panel, field.words().in(changes.language()), LinearColour.onScreen(before));
        if (chosen != null) {
            // A light is brighter than a screen: the choice keeps its strength.
            double strength = Math.max(1, LinearColour.greatest(before));
            changes.set(field, LinearColour.linear(chosen).scaled(strength));
        }
    }

    FieldEditor editor() {
        return new FieldEditor(panel, this::show);
    }

    private void show(InspectorField next) {
        field = next;
        for (int axis = 0; axis < 3; axis++) {
            ToDoubleFunction<Vec3> part = AXES.get(axis);
            Set<Double> values = next.values().stream()
                    .filter(Vec3.class::isInstance)
                    .map(value -> part.applyAsDouble((Vec3) value))
                    .collect(Collectors.toSet());
            inputs.get(axis)
                    .show(values.size() == 1 ? values.iterator().next() : null, FieldEditor.placeholder(next, changes));
        }
        swatch.setIcon(next.value() instanceof Vec3 colour ? PanelIcon.swatch(LinearColour.onScreen(colour)) : null);
    }
}
