package nephele.editor.window.page;

import java.util.List;
import java.util.stream.Collectors;
import javax.swing.table.AbstractTableModel;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.editor.window.dialog.Searches;
import nephele.engine.level.Language;

/** The actions with their keys and what else has them, narrowed by a filter. */
final class KeyTable extends AbstractTableModel {
    static final int CONFLICT = 3;

    private static final long serialVersionUID = 1;
    private static final List<PageText> COLUMNS =
            List.of(PageText.ACTION, PageText.MENU, PageText.KEYS, PageText.CONFLICT);

    private final transient List<EditorCommand> commands;
    private transient List<EditorCommand> listed = List.of();
    private transient EditorKeys keys;
    private transient Language language = Language.EN;
    private String filter = "";

    KeyTable(List<EditorCommand> commands) {
        this.commands = commands;
    }

    /** Shows other keys in a language. */
    void show(EditorKeys now, Language next) {
        keys = now;
        language = next;
        filter(filter);
    }

    /** Shows the actions whose title, menu or keys have all words. */
    void filter(String words) {
        filter = words;
        listed = commands.stream()
                .filter(command -> Searches.hasWords(
                        words,
                        command.title().in(language),
                        command.title().english(),
                        command.menu().title().in(language),
                        keyText(command)))
                .toList();
        fireTableDataChanged();
    }

    EditorCommand command(int row) {
        return listed.get(row);
    }

    int row(EditorCommand command) {
        return listed.indexOf(command);
    }

    boolean hasConflict(int row) {
        return !conflictText(listed.get(row)).isEmpty();
    }

    @Override
    public int getRowCount() {
        return listed.size();
    }

    @Override
    public int getColumnCount() {
        return COLUMNS.size();
    }

    @Override
    public String getColumnName(int column) {
        return COLUMNS.get(column).in(language);
    }

    @Override
    public Object getValueAt(int row, int column) {
        EditorCommand command = listed.get(row);
        return switch (column) {
            case 0 -> command.title().in(language);
            case 1 -> command.menu().title().in(language);
            case 2 -> keyText(command);
            default -> conflictText(command);
        };
    }

    private String keyText(EditorCommand command) {
        return keys.of(command.id()).stream().map(KeyText::text).collect(Collectors.joining("   "));
    }

    private String conflictText(EditorCommand command) {
        return keys.conflicts().entrySet().stream()
                .filter(conflict -> conflict.getValue().contains(command.id()))
                .map(conflict -> PageText.ALSO
                        .with(conflict.getKey().text(), others(conflict.getValue(), command))
                        .in(language))
                .collect(Collectors.joining("; "));
    }

    private String others(List<String> rivals, EditorCommand command) {
        return commands.stream()
                .filter(other -> other != command && rivals.contains(other.id()))
                .map(other -> other.title().in(language))
                .collect(Collectors.joining(", "));
    }
}
