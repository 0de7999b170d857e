package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Cursor;
import java.awt.FontMetrics;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.InspectorModel;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.FieldKind;
import nephele.editor.record.ListEdit;
import nephele.editor.text.FieldWords;

/** A line of the inspector: title, editor and menu. A number is also changed by a drag on its title. */
final class FieldLine {
    private static final int INDENT_POINTS = 10;
    private static final int LONGEST_TITLE_POINTS = 112;
    private static final int LONGEST_CHOICE_POINTS = 104;

    private final FieldChanges changes;
    private final JLabel title = new JLabel();
    private final FieldEditor editor;
    private final JButton menu = new JButton(PanelIcon.MENU);
    private InspectorField field;

    FieldLine(InspectorField field, FieldChanges changes, AssetChooser chooser) {
        this.field = field;
        this.changes = changes;
        editor = FieldEditor.make(field, changes, chooser);
        menu.putClientProperty(FlatClientProperties.BUTTON_TYPE, FlatClientProperties.BUTTON_TYPE_TOOLBAR_BUTTON);
        menu.addActionListener(event -> menu().show(menu, 0, menu.getHeight()));
        title.setLabelFor(editor.component());
        if (field.type().isShifted()) {
            listenToDrags();
        }
        show(field);
    }

    void addTo(JPanel panel) {
        // The layout scales its own lengths.
        String indent = "gapleft " + INDENT_POINTS * field.depth();
        int indentPixels = UIScale.scale(INDENT_POINTS * field.depth());
        FieldKind kind = field.type().kind();
        boolean isLong = title.getPreferredSize().width + indentPixels > UIScale.scale(LONGEST_TITLE_POINTS);
        if (kind == FieldKind.TRUTH && isLong) {
            panel.add(title, indent + ", span 2, split 2, wmin 0");
            panel.add(editor.component());
            panel.add(menu);
            return;
        }
        boolean isWide = kind == FieldKind.VECTOR || kind == FieldKind.ASSET || kind == FieldKind.EXPOSURE;
        if (isWide || isLong || hasLongChoice()) {
            // Several inputs, the name of a file, a long title and a long choice need the whole width to be readable.
            panel.add(title, indent + ", span 2, wmin 0");
            panel.add(menu);
            panel.add(editor.component(), indent + ", span 3, growx, w 40:120:");
            return;
        }
        panel.add(title, indent);
        panel.add(editor.component(), "growx, wmin 40");
        panel.add(menu);
    }

    private boolean hasLongChoice() {
        FontMetrics metrics = title.getFontMetrics(title.getFont());
        return field.type().kind() == FieldKind.CHOICE
                && field.type().choices().stream()
                        .map(choice -> FieldWords.choice(choice).in(changes.language()))
                        .anyMatch(word -> metrics.stringWidth(word) > UIScale.scale(LONGEST_CHOICE_POINTS));
    }

    InspectorField field() {
        return field;
    }

    /** Shows a field of the same form. */
    void show(InspectorField next) {
        field = next;
        String words = next.words().in(changes.language());
        String unit = next.isEntry() ? "" : next.type().field().unit();
        title.setText(unit.isEmpty() ? words : words + " (" + unit + ")");
        title.setToolTipText(next.type().field().name() + "  " + next.type().range());
        menu.getAccessibleContext()
                .setAccessibleName(PanelText.MENU_OF.with(words).in(changes.language()));
        menu.setVisible(menu().getComponentCount() > 0);
        editor.component().getAccessibleContext().setAccessibleName(words);
        editor.show().accept(next);
        enable(editor.component(), !next.isUnset());
    }

    private void enable(Component component, boolean isEnabled) {
        // A combo without a value can still choose one; that sets it.
        boolean isChoice = field.type().kind() == FieldKind.REFERENCE
                || field.type().kind() == FieldKind.CHOICE
                || field.type().kind() == FieldKind.VARIANT
                || field.type().kind() == FieldKind.ASSET;
        component.setEnabled(isEnabled || isChoice);
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                enable(child, isEnabled);
            }
        }
    }

    private JPopupMenu menu() {
        JPopupMenu items = new JPopupMenu();
        var type = field.type();
        if (type.isNullable() && (field.isUnset() || field.isMixed())) {
            item(items, PanelText.SET_FIELD, () -> changes.setFresh(field));
        }
        if (type.isNullable() && !field.isUnset()) {
            item(items, PanelText.UNSET_FIELD, () -> changes.unset(field));
        }
        if (field.canReset() && !type.isNullable()) {
            item(items, PanelText.RESET_FIELD, () -> changes.reset(field));
        }
        if (type.kind() == FieldKind.LIST) {
            item(items, PanelText.ADD_TO, () -> changes.add(field, null));
        } else if (type.kind() == FieldKind.TABLE) {
            addKeys(items);
        }
        if (field.path().last().entry() instanceof Integer index) {
            addListEdits(items, index);
        }
        if (field.isEntry()) {
            item(items, PanelText.REMOVE_FROM, () -> changes.remove(field));
        }
        return items;
    }

    private void addListEdits(JPopupMenu items, int index) {
        if (index > 0) {
            item(items, PanelText.MOVE_UP_IN, () -> changes.edit(field, ListEdit.moved(index, index - 1)));
        }
        if (index < changes.length(field) - 1) {
            item(items, PanelText.MOVE_DOWN_IN, () -> changes.edit(field, ListEdit.moved(index, index + 1)));
        }
        item(items, PanelText.INSERT_INTO, () -> changes.edit(field, ListEdit.inserted(index)));
    }

    private void addKeys(JPopupMenu items) {
        var keys = changes.missingKeys(field);
        for (Object key : keys) {
            String text =
                    PanelText.ADD_TO.with(field.words().in(changes.language())).in(changes.language()) + ": "
                            + FieldWords.choiceInFiles(key);
            items.add(text).addActionListener(event -> changes.add(field, key));
        }
        if (keys.isEmpty() && InspectorModel.hasTextKeys(field)) {
            item(items, PanelText.ADD_TO, this::askForKey);
        }
    }

    private void askForKey() {
        String key = JOptionPane.showInputDialog(menu, PanelText.KEY_TO_ADD.in(changes.language()));
        if (key != null && !key.isBlank()) {
            changes.add(field, key.strip());
        }
    }

    private void item(JPopupMenu items, PanelText text, Runnable action) {
        String name = FieldWords.of(field.type().field()).in(changes.language());
        items.add(text.with(name).in(changes.language())).addActionListener(event -> action.run());
    }

    private void listenToDrags() {
        title.setCursor(Cursor.getPredefinedCursor(Cursor.E_RESIZE_CURSOR));
        var drag = new MouseAdapter() {
            private int startX;

            @Override
            public void mousePressed(MouseEvent event) {
                startX = event.getX();
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                double step = event.isShiftDown() ? 0.001 : 0.01;
                double change = (event.getX() - startX) * (field.type().kind() == FieldKind.WHOLE ? 0.1 : step);
                changes.drag(field, old -> field.type().shifted(old, change));
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                changes.endDrag(field);
            }
        };
        title.addMouseListener(drag);
        title.addMouseMotionListener(drag);
    }
}
