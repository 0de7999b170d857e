package nephele.editor.window.dialog;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.util.function.Function;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import javax.swing.SwingConstants;
import javax.swing.UIManager;

/** Paints the rows of a search list in three columns that stay aligned from row to row. */
final class SearchCell<T> extends JPanel implements ListCellRenderer<T> {
    private static final int INSET_POINTS = 8;
    private static final double ASIDE_AT = 0.56;
    private static final double TRAILING_AT = 0.76;

    private final transient Function<T, SearchRow> rows;
    private final int rowPoints;
    private final JLabel title = new JLabel();
    private final JLabel aside = new JLabel();
    private final JLabel trailing = new JLabel("", SwingConstants.TRAILING);

    SearchCell(Function<T, SearchRow> rows, int rowPoints) {
        super(null);
        this.rows = rows;
        this.rowPoints = rowPoints;
        add(title);
        add(aside);
        add(trailing);
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends T> list, T value, int index, boolean isSelected, boolean hasFocus) {
        SearchRow row = rows.apply(value);
        title.setText(row.title());
        title.setIcon(row.icon());
        aside.setText(row.aside());
        trailing.setText(row.trailing());
        Color text = isSelected ? list.getSelectionForeground() : list.getForeground();
        Color faint = isSelected ? text : UIManager.getColor("Label.disabledForeground");
        title.setForeground(row.isEnabled() ? text : faint);
        aside.setForeground(faint);
        trailing.setForeground(isSelected ? text : faint);
        setBackground(isSelected ? list.getSelectionBackground() : list.getBackground());
        setToolTipText(row.title());
        getAccessibleContext().setAccessibleName(row.title() + " " + row.aside() + " " + row.trailing());
        return this;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(360), UIScale.scale(rowPoints));
    }

    @Override
    public void doLayout() {
        int inset = UIScale.scale(INSET_POINTS);
        int end = getWidth() - inset;
        int asideAt = aside.getText().isEmpty() ? end : (int) (ASIDE_AT * getWidth());
        int trailingAt = trailing.getText().isEmpty() ? end : (int) (TRAILING_AT * getWidth());
        title.setBounds(inset, 0, Math.min(asideAt, trailingAt) - inset, getHeight());
        aside.setBounds(asideAt, 0, Math.max(0, trailingAt - asideAt - inset / 2), getHeight());
        trailing.setBounds(trailingAt, 0, Math.max(0, end - trailingAt), getHeight());
    }

    /** Lays out at once: a cell has no window, and without a display validation would do nothing. */
    @Override
    public void validate() {
        doLayout();
    }
}
