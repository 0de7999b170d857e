package nephele.editor.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import javax.swing.table.AbstractTableModel;
import nephele.editor.panel.model.OutlinerRow;
import nephele.editor.panel.model.PanelText;
import nephele.editor.text.EntityWords;
import nephele.engine.level.Language;

/** The lines of the outliner as a table of name, eye and lock, which reports only lines that differ as changed. */
final class OutlinerTable extends AbstractTableModel {
    static final int NAME = 0;
    static final int EYE = 1;
    static final int LOCK = 2;

    private final transient BiConsumer<OutlinerRow, String> rename;
    private transient List<OutlinerRow> rows = List.of();
    private Language language = Language.EN;

    OutlinerTable(BiConsumer<OutlinerRow, String> rename) {
        this.rename = rename;
    }

    void language(Language next) {
        language = next;
    }

    List<OutlinerRow> rows() {
        return rows;
    }

    /** Takes other lines; tells of no change, of changed lines, or of one block of lines that came or went. */
    void rows(List<OutlinerRow> next) {
        List<OutlinerRow> before = rows;
        rows = new ArrayList<>(next);
        if (before.size() == next.size()) {
            for (int i = 0; i < next.size(); i++) {
                if (!before.get(i).equals(next.get(i))) {
                    fireTableRowsUpdated(i, i);
                }
            }
            return;
        }
        int shorter = Math.min(before.size(), next.size());
        int head = 0;
        while (head < shorter && before.get(head).key().equals(next.get(head).key())) {
            head++;
        }
        int tail = 0;
        while (tail < shorter - head
                && before.get(before.size() - 1 - tail)
                        .key()
                        .equals(next.get(next.size() - 1 - tail).key())) {
            tail++;
        }
        if (before.size() > head + tail) {
            fireTableRowsDeleted(head, before.size() - tail - 1);
        }
        if (next.size() > head + tail) {
            fireTableRowsInserted(head, next.size() - tail - 1);
        }
        for (int i = 0; i < next.size(); i++) {
            int old = i < head ? i : i - next.size() + before.size();
            if ((i < head || i >= next.size() - tail) && !before.get(old).equals(next.get(i))) {
                fireTableRowsUpdated(i, i);
            }
        }
    }

    @Override
    public int getRowCount() {
        return rows.size();
    }

    @Override
    public int getColumnCount() {
        return 3;
    }

    @Override
    public String getColumnName(int column) {
        return switch (column) {
            case EYE -> PanelText.VISIBILITY.in(language);
            case LOCK -> PanelText.LOCK.in(language);
            default -> PanelText.NAME.in(language);
        };
    }

    @Override
    public Object getValueAt(int row, int column) {
        OutlinerRow line = rows.get(row);
        return switch (column) {
            case EYE -> (line.state().isHidden() ? PanelText.HIDDEN : PanelText.SHOWN).in(language);
            case LOCK -> (line.state().isLocked() ? PanelText.LOCKED : PanelText.UNLOCKED).in(language);
            default -> title(line);
        };
    }

    private String title(OutlinerRow line) {
        return switch (line.kind()) {
            case GROUPS -> PanelText.GROUPS.in(language);
            case SECTION ->
                EntityWords.ofSection(line.key()).in(language) + " ("
                        + line.members().size() + ")";
            default -> isSingle(line) ? EntityWords.ofSection(line.key()).in(language) : line.title();
        };
    }

    private static boolean isSingle(OutlinerRow line) {
        return line.kind() == OutlinerRow.Kind.ENTITY
                && line.members().get(0).id().isEmpty();
    }

    @Override
    public boolean isCellEditable(int row, int column) {
        OutlinerRow line = rows.get(row);
        return column == NAME
                && line.kind() == OutlinerRow.Kind.ENTITY
                && !line.members().get(0).id().isEmpty();
    }

    @Override
    public void setValueAt(Object value, int row, int column) {
        rename.accept(rows.get(row), String.valueOf(value).strip());
    }
}
