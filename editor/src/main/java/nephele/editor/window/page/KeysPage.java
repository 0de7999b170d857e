package nephele.editor.window.page;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import javax.swing.table.DefaultTableCellRenderer;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSettings;
import nephele.editor.widget.ComponentKeys;
import nephele.editor.widget.TextListener;
import nephele.editor.window.dialog.DialogFrame;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** All actions with their keys: search, press a key to bind it, see conflicts, reset. Changes hold at once. */
final class KeysPage extends JPanel {
    private static final long serialVersionUID = 1;
    /** The keys that a user has chosen instead of the defaults, as the settings keep them. */
    private static final class KeyChoices {
        private final List<EditorCommand> commands;
        private final EditorSettings settings;

        public KeyChoices(List<EditorCommand> commands, EditorSettings settings) {
            this.commands = List.copyOf(commands);
            this.settings = settings;
        }

        /** Returns the keys in use. */
        public EditorKeys keys() {
            return new EditorKeys(commands, settings.get(EditorSetting.KEYS));
        }

        /** Returns the settings with exactly these keys of a command; its defaults leave no entry. */
        public EditorSettings with(EditorCommand command, List<KeyText> keys) {
            Map<String, List<String>> chosen = new LinkedHashMap<>(settings.get(EditorSetting.KEYS));
            List<KeyText> defaults = command.keys().stream()
                    .flatMap(text -> KeyText.parse(text).stream())
                    .toList();
            if (keys.equals(defaults)) {
                chosen.remove(command.id());
            } else {
                chosen.put(command.id(), keys.stream().map(KeyText::text).toList());
            }
            return settings.with(EditorSetting.KEYS, chosen);
        }

        /** Returns the settings with one more key of a command; the oldest goes if there are too many. */
        public EditorSettings withAdded(EditorCommand command, KeyText key) {
            List<KeyText> all = Stream.concat(keys().of(command.id()).stream(), Stream.of(key))
                    .distinct()
                    .toList();
            return with(command, all.subList(Math.max(0, all.size() - EditorSetting.MOST_KEYS), all.size()));
        }

        /** Returns the settings with the default keys of a command. */
        public EditorSettings reset(EditorCommand command) {
            Map<String, List<String>> chosen = new LinkedHashMap<>(settings.get(EditorSetting.KEYS));
            chosen.remove(command.id());
            return settings.with(EditorSetting.KEYS, chosen);
        }

        /** Returns the settings with the default keys of all commands. */
        public EditorSettings resetAll() {
            return settings.with(EditorSetting.KEYS, Map.of());
        }
    }

    private final transient EditorSession session;
    private final transient List<EditorCommand> commands;
    private final KeyTable model;
    private final JTable table;
    private final KeyCapture capture = new KeyCapture();
    private final JLabel conflicts = new JLabel();

    KeysPage(EditorSession session, List<EditorCommand> commands) {
        super(new MigLayout("insets 10, fill, wrap 1", "[grow, fill]", "[][grow, fill][][][]"));
        this.session = session;
        this.commands = commands;
        model = new KeyTable(commands);
        table = new JTable(model);
        Language language = session.language();
        add(filter(language));
        arrangeTable(language);
        add(new JScrollPane(table), "hmin 260lp");
        add(capture, "wmin 0");
        add(conflicts, "wmin 0");
        add(buttons(language));
        refresh(null);
    }

    private JTextField filter(Language language) {
        JTextField filter = new JTextField();
        filter.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, PageText.FILTER.in(language));
        filter.getAccessibleContext().setAccessibleName(PageText.FILTER.in(language));
        filter.getDocument().addDocumentListener(new TextListener(() -> model.filter(filter.getText())));
        return filter;
    }

    private void arrangeTable(Language language) {
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setRowHeight(UIScale.scale(24));
        table.setFillsViewportHeight(true);
        table.setPreferredScrollableViewportSize(new Dimension(UIScale.scale(740), UIScale.scale(380)));
        table.setDefaultRenderer(Object.class, new Cell());
        table.getAccessibleContext().setAccessibleName(PageText.KEYS.in(language));
        int[] widths = {240, 104, 176, 220};
        for (int i = 0; i < widths.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
        }
        ComponentKeys.bind(
                table, "ENTER", () -> await((choices, command) -> key -> choices.with(command, List.of(key))));
        ComponentKeys.bind(table, "DELETE", () -> change((choices, command) -> choices.with(command, List.of())));
    }

    private JPanel buttons(Language language) {
        JPanel row = new JPanel(new MigLayout("insets 0, gap 6", "[][][][]push[]"));
        button(
                row,
                PageText.REPLACE.in(language),
                () -> await((choices, command) -> key -> choices.with(command, List.of(key))));
        button(
                row,
                PageText.ADD.in(language),
                () -> await((choices, command) -> key -> choices.withAdded(command, key)));
        button(row, PageText.REMOVE.in(language), () -> change((choices, command) -> choices.with(command, List.of())));
        button(row, PageText.RESET.in(language), () -> change(KeyChoices::reset));
        button(row, PageText.RESET_ALL.in(language), () -> {
            session.settings(choices().resetAll());
            refresh(selected().orElse(null));
        });
        return row;
    }

    private static void button(JPanel row, String text, Runnable run) {
        JButton button = new JButton(text);
        button.addActionListener(event -> run.run());
        row.add(button);
    }

    private KeyChoices choices() {
        return new KeyChoices(commands, session.settings());
    }

    private Optional<EditorCommand> selected() {
        return table.getSelectedRow() < 0 ? Optional.empty() : Optional.of(model.command(table.getSelectedRow()));
    }

    private void change(BiFunction<KeyChoices, EditorCommand, EditorSettings> change) {
        selected().ifPresent(command -> {
            session.settings(change.apply(choices(), command));
            refresh(command);
        });
    }

    private void await(BiFunction<KeyChoices, EditorCommand, Function<KeyText, EditorSettings>> change) {
        selected()
                .ifPresent(command -> capture.await(
                        PageText.PRESS.in(session.language(), command.title().in(session.language())), key -> {
                            key.ifPresent(pressed -> session.settings(
                                    change.apply(choices(), command).apply(pressed)));
                            refresh(command);
                            table.requestFocusInWindow();
                        }));
    }

    /** @param selected stays selected; {@code null} for the first */
    private void refresh(EditorCommand selected) {
        Language language = session.language();
        model.show(choices().keys(), language);
        int row = selected == null ? 0 : model.row(selected);
        if (row >= 0 && row < model.getRowCount()) {
            table.setRowSelectionInterval(row, row);
        }
        capture.setText(PageText.HOW.in(language));
        int count = choices().keys().conflicts().size();
        conflicts.setText(count == 0 ? PageText.NO_CONFLICTS.in(language) : PageText.CONFLICTS.in(language, count));
        conflicts.setForeground(count == 0 ? UIManager.getColor("Label.foreground") : DialogFrame.errorColour());
    }

    JTable table() {
        return table;
    }

    KeyCapture capture() {
        return capture;
    }

    private final class Cell extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1;

        @Override
        public Component getTableCellRendererComponent(
                JTable all, Object value, boolean isSelected, boolean hasFocus, int row, int column) {
            super.getTableCellRendererComponent(all, value, isSelected, hasFocus, row, column);
            boolean isRed = !isSelected && column >= KeyTable.CONFLICT - 1 && model.hasConflict(row);
            setForeground(
                    isRed
                            ? DialogFrame.errorColour()
                            : isSelected ? all.getSelectionForeground() : all.getForeground());
            setToolTipText(String.valueOf(value));
            return this;
        }
    }
}
