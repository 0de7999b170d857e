package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Font;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Picker;
import nephele.editor.document.Registration;
import nephele.editor.document.Selection;
import nephele.editor.panel.model.EntityQuery;
import nephele.editor.panel.model.EntityStatus;
import nephele.editor.panel.model.OutlinerModel;
import nephele.editor.panel.model.OutlinerRow;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Limits;
import nephele.editor.widget.EntityIcons;
import nephele.editor.widget.Listeners;
import nephele.engine.level.TextKind;
import net.miginfocom.swing.MigLayout;

/**
 * The list of everything in the level by section, with a search. Space folds or hides, L locks, F2 renames, Delete
 * deletes, Enter and a double click look at an entity.
 */
public final class OutlinerPanel extends JPanel implements AutoCloseable {
    private final transient EditorSession session;
    private final transient Registration registration;
    private final transient Consumer<EntityRef> focus;
    private final transient Consumer<List<EntityRef>> delete;
    private final transient OutlinerModel model = new OutlinerModel(Entities.LEVEL);
    private final JTextField search = new JTextField();
    private final JLabel error = new JLabel();
    private final OutlinerTable lines;
    private final JTable table;
    private transient EntityQuery query = EntityQuery.ALL;
    private boolean isUpdating;

    /**
     * @param focus called with the entity that the views shall look at
     * @param delete called with the entities that shall be deleted
     */
    public OutlinerPanel(EditorSession session, Consumer<EntityRef> focus, Consumer<List<EntityRef>> delete) {
        super(new MigLayout("insets 4, fill, wrap 1, hidemode 3", "[grow, fill]", ""));
        this.session = session;
        this.focus = focus;
        this.delete = delete;
        lines = new OutlinerTable((row, id) -> rename(row.members().get(0), id));
        table = new JTable(lines);
        arrangeTable();
        add(search);
        add(error);
        add(new JScrollPane(table), "push, grow");
        Listeners.onText(search, this::searched);
        table.getSelectionModel().addListSelectionListener(event -> selectInDocument());
        bindKeys();
        registration = session.listen(change -> {
            if (change == SessionChange.SETTINGS) {
                translate();
            } else if (change == SessionChange.DOCUMENT || change == SessionChange.FILE) {
                refresh();
            }
        });
        error.setVisible(false);
        translate();
    }

    private void arrangeTable() {
        table.setTableHeader(null);
        table.setShowGrid(false);
        table.setFillsViewportHeight(true);
        table.setDefaultRenderer(Object.class, cells());
        // A key that is typed shall not begin to rename; F2 does.
        table.putClientProperty("JTable.autoStartsEdit", Boolean.FALSE);
        for (int column : new int[] {OutlinerTable.EYE, OutlinerTable.LOCK}) {
            TableColumn narrow = table.getColumnModel().getColumn(column);
            narrow.setMinWidth(UIScale.scale(24));
            narrow.setMaxWidth(UIScale.scale(24));
        }
        table.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                pressed(event);
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                showMenu(event);
            }
        });
    }

    private TableCellRenderer cells() {
        return new DefaultTableCellRenderer() {
            @Override
            public Component getTableCellRendererComponent(
                    JTable any, Object value, boolean isSelected, boolean hasFocus, int row, int column) {
                super.getTableCellRendererComponent(any, value, isSelected, hasFocus, row, column);
                OutlinerRow line = lines.rows().get(row);
                boolean isName = column == OutlinerTable.NAME;
                setText(isName ? String.valueOf(value) : "");
                setIcon(icon(line, column));
                setHorizontalAlignment(isName ? SwingConstants.LEADING : SwingConstants.CENTER);
                setFont(any.getFont().deriveFont(line.hasFold() ? Font.BOLD : Font.PLAIN));
                int indent = isName ? UIScale.scale(4 + 14 * line.depth()) : 0;
                setBorder(BorderFactory.createEmptyBorder(0, indent, 0, 0));
                getAccessibleContext().setAccessibleName(String.valueOf(value));
                return this;
            }
        };
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
        return line.members().isEmpty() ? null : symbol(line.members().get(0));
    }

    private Icon symbol(EntityRef ref) {
        // A level has many solids, and the search for each of those in view would be slow.
        boolean isOfOneSymbol = ref.section().equals(Picker.SOLIDS);
        Optional<Record> entity = isOfOneSymbol
                ? Optional.empty()
                : Entities.LEVEL.find(session.document().level(), ref);
        return EntityIcons.of(
                ref.section(),
                entity.map(record -> RecordKind.of(record).name()).orElse(""));
    }

    private void bindKeys() {
        key("F2", () -> table.editCellAt(table.getSelectedRow(), OutlinerTable.NAME));
        key("DELETE", () -> delete.accept(selected()));
        key("ENTER", this::focusOnSelected);
        key("L", () -> toggleLocked(members()));
        key("SPACE", this::foldOrHide);
        key("LEFT", () -> fold(true));
        key("RIGHT", () -> fold(false));
    }

    private void key(String stroke, Runnable action) {
        Listeners.onKey(table, stroke, () -> {
            // The field of a rename has no use for some keys and passes them on.
            if (!table.isEditing()) {
                action.run();
            }
        });
    }

    private void translate() {
        lines.language(session.language());
        search.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, PanelText.SEARCH.in(session.language()));
        search.getAccessibleContext().setAccessibleName(PanelText.SEARCH.in(session.language()));
        table.getAccessibleContext().setAccessibleName(PanelText.OUTLINER.in(session.language()));
        table.setRowHeight(UIScale.scale(20));
        showErrors();
        refresh();
        table.repaint();
        search.repaint();
    }

    private void searched() {
        query = EntityQuery.parse(search.getText(), Entities.LEVEL);
        showErrors();
        refresh();
    }

    /** Searches as if the text had been typed. */
    public void search(String text) {
        search.setText(text);
    }

    /** Takes the keyboard to the search, whose text is selected. */
    public void startSearch() {
        search.requestFocusInWindow();
        search.selectAll();
    }

    private void showErrors() {
        error.setVisible(!query.errors().isEmpty());
        error.setText(query.errors().isEmpty() ? "" : query.errors().get(0).in(session.language()));
    }

    private void refresh() {
        var level = session.document().level();
        List<OutlinerRow> rows = model.rows(level, EntityStatus.of(level.editor()), query);
        isUpdating = true;
        if (table.isEditing() && !rows.equals(lines.rows())) {
            // The editor belongs to a row number, at which there may be another entity now, or none.
            table.getCellEditor().cancelCellEditing();
        }
        lines.rows(rows);
        selectInTable();
        isUpdating = false;
    }

    private List<OutlinerRow> selectedRows() {
        List<OutlinerRow> rows = new ArrayList<>();
        for (int row : table.getSelectedRows()) {
            rows.add(lines.rows().get(row));
        }
        return rows;
    }

    private List<EntityRef> selected() {
        return selectedRows().stream()
                .flatMap(row -> row.selected().stream())
                .distinct()
                .toList();
    }

    private List<EntityRef> members() {
        return selectedRows().stream()
                .flatMap(row -> row.members().stream())
                .distinct()
                .toList();
    }

    private void selectInDocument() {
        if (!isUpdating) {
            session.document().select(Selection.of(selected()));
        }
    }

    private void selectInTable() {
        Set<EntityRef> wanted =
                new LinkedHashSet<>(session.document().selection().entities());
        if (wanted.equals(new LinkedHashSet<>(selected()))) {
            return;
        }
        var selection = table.getSelectionModel();
        selection.setValueIsAdjusting(true);
        table.clearSelection();
        int first = -1;
        for (int i = 0; i < lines.rows().size(); i++) {
            OutlinerRow row = lines.rows().get(i);
            if (row.kind() == OutlinerRow.Kind.ENTITY
                    && wanted.contains(row.members().get(0))) {
                table.addRowSelectionInterval(i, i);
                first = first < 0 ? i : first;
            }
        }
        selection.setValueIsAdjusting(false);
        if (first >= 0) {
            table.scrollRectToVisible(table.getCellRect(first, 0, true));
        }
    }

    private void pressed(MouseEvent event) {
        int at = table.rowAtPoint(event.getPoint());
        if (at < 0 || event.isPopupTrigger()) {
            showMenu(event);
            return;
        }
        OutlinerRow row = lines.rows().get(at);
        int column = table.columnAtPoint(event.getPoint());
        if (column == OutlinerTable.EYE) {
            toggleHidden(row.members());
        } else if (column == OutlinerTable.LOCK) {
            toggleLocked(row.members());
        } else if (row.hasFold() && event.getX() < UIScale.scale(24 + 14 * row.depth())) {
            toggleFold(row);
        } else if (event.getClickCount() == 2) {
            focusOnSelected();
        }
    }

    private void toggleFold(OutlinerRow row) {
        model.toggleFold(row.key());
        refresh();
    }

    private void fold(boolean shut) {
        selectedRows().stream()
                .filter(row -> row.hasFold() && row.state().isOpen() == shut)
                .forEach(this::toggleFold);
    }

    private void foldOrHide() {
        List<OutlinerRow> rows = selectedRows();
        if (rows.size() == 1 && rows.get(0).hasFold()) {
            toggleFold(rows.get(0));
        } else {
            toggleHidden(members());
        }
    }

    private void focusOnSelected() {
        selected().stream().findFirst().ifPresent(focus);
    }

    private void showMenu(MouseEvent event) {
        if (event.isPopupTrigger()) {
            menu().show(table, event.getX(), event.getY());
        }
    }

    /** Returns the context menu for the selected lines. */
    JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        item(menu, PanelText.FOCUS, this::focusOnSelected);
        item(menu, PanelText.FIND_USAGES, () -> selected().stream().findFirst().ifPresent(this::selectUsages));
        item(menu, PanelText.RENAME, () -> table.editCellAt(table.getSelectedRow(), OutlinerTable.NAME));
        item(menu, PanelText.DELETE, () -> delete.accept(selected()));
        return menu;
    }

    private void item(JPopupMenu menu, PanelText text, Runnable action) {
        menu.add(text.in(session.language())).addActionListener(event -> action.run());
    }

    private static String named(List<EntityRef> refs) {
        return refs.size() == 1 ? refs.get(0).shortName() : String.valueOf(refs.size());
    }

    private void toggleHidden(List<EntityRef> refs) {
        if (!refs.isEmpty()) {
            session.document()
                    .edit(PanelText.SHOW_OR_HIDE.with(named(refs)), level -> NoteEdits.hiddenToggled(level, refs));
        }
    }

    private void toggleLocked(List<EntityRef> refs) {
        if (!refs.isEmpty()) {
            session.document()
                    .edit(PanelText.LOCK_OR_UNLOCK.with(named(refs)), level -> NoteEdits.lockedToggled(level, refs));
        }
    }

    private void rename(EntityRef ref, String id) {
        EntityRef renamed = new EntityRef(ref.section(), id);
        if (id.isEmpty() || id.equals(ref.id())) {
            return;
        }
        if (id.length() > TextKind.ID.longest()) {
            session.status(Limits.length(id.substring(0, 8) + "…", TextKind.ID));
            return;
        }
        if (Entities.LEVEL.find(session.document().level(), renamed).isPresent()) {
            session.status(PanelText.ID_TAKEN.with(id));
            return;
        }
        session.document().edit(PanelText.RENAME_TO.with(id), null, now -> now.renamed(ref, id));
    }

    /** Selects what refers to an entity, and reports how much it is. */
    private void selectUsages(EntityRef ref) {
        Set<EntityRef> usages = Entities.LEVEL.usages(session.document().level(), ref);
        if (usages.isEmpty()) {
            session.status(PanelText.NO_USAGES.with(ref.shortName()));
        } else {
            session.document().select(Selection.of(usages));
            session.status(PanelText.USAGES.with(usages.size(), ref.shortName()));
        }
    }

    @Override
    public void close() {
        registration.close();
    }
}
