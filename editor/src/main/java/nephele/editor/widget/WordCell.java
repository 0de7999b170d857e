package nephele.editor.widget;

import java.awt.Component;
import java.util.function.Function;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;

/** Paints each value of a list or a choice with its word. */
public final class WordCell<T> extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1;

    private final transient Function<? super T, String> word;

    /** @param word returns that of a value */
    public WordCell(Function<? super T, String> word) {
        this.word = word;
    }

    @Override
    @SuppressWarnings("unchecked") // a list shows only values of its type
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean isSelected, boolean hasFocus) {
        String text = value == null ? "" : word.apply((T) value);
        return super.getListCellRendererComponent(list, text, index, isSelected, hasFocus);
    }
}
