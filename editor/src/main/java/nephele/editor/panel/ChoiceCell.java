package nephele.editor.panel;

import java.awt.Component;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;

/** Paints a choice with its word. */
final class ChoiceCell extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean isSelected, boolean hasFocus) {
        return super.getListCellRendererComponent(list, FieldEditors.word(value), index, isSelected, hasFocus);
    }
}
