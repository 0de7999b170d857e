package nephele.editor.panel;

import java.awt.Component;
import java.util.function.Function;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;

/** Paints a choice with its word. */
final class ChoiceCell extends DefaultListCellRenderer {
    private final transient Function<Object, String> word;

    ChoiceCell(Function<Object, String> word) {
        this.word = word;
    }

    @Override
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean isSelected, boolean hasFocus) {
        return super.getListCellRendererComponent(
                list, value == null ? "" : word.apply(value), index, isSelected, hasFocus);
    }
}
