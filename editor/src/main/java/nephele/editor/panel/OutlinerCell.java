package nephele.editor.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Font;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import nephele.editor.panel.model.OutlinerRow;
import nephele.editor.record.EntityRef;

/** Paints a cell of the outliner. */
final class OutlinerCell extends DefaultTableCellRenderer {
    private final transient Function<EntityRef, Icon> symbols;

    /** @param symbols returns that of an entity */
    OutlinerCell(Function<EntityRef, Icon> symbols) {
        this.symbols = symbols;
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean isSelected, boolean hasFocus, int row, int column) {
        super.getTableCellRendererComponent(table, value, isSelected, hasFocus, row, column);
        OutlinerRow line = ((OutlinerTable) table.getModel()).rows().get(row);
        boolean isName = column == OutlinerTable.NAME;
        setText(isName ? String.valueOf(value) : "");
        setIcon(icon(line, column));
        setHorizontalAlignment(isName ? SwingConstants.LEADING : SwingConstants.CENTER);
        setFont(table.getFont().deriveFont(line.hasFold() ? Font.BOLD : Font.PLAIN));
        int indent = isName ? UIScale.scale(4 + 14 * line.depth()) : 0;
        setBorder(BorderFactory.createEmptyBorder(0, indent, 0, 0));
        getAccessibleContext().setAccessibleName(String.valueOf(value));
        return this;
    }

    private Icon icon(OutlinerRow line, int column) {
        boolean isBare = line.members().isEmpty();
        return switch (column) {
            case OutlinerTable.EYE -> isBare ? null : line.state().isHidden() ? PanelIcon.EYE_SHUT : PanelIcon.EYE;
            case OutlinerTable.LOCK -> isBare ? null : line.state().isLocked() ? PanelIcon.PADLOCK : PanelIcon.DOT;
            default ->
                line.hasFold() ? (line.state().isOpen() ? PanelIcon.FOLD_OPEN : PanelIcon.FOLD_SHUT) : symbol(line);
        };
    }

    private Icon symbol(OutlinerRow line) {
        return line.members().isEmpty() ? null : symbols.apply(line.members().get(0));
    }
}
