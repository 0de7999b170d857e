package nephele.editor.window.page;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
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
import javax.swing.table.TableCellRenderer;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.widget.Listeners;
import nephele.editor.window.dialog.DialogFrame;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** All actions with their keys: search, press a key to bind it, see conflicts, reset. Changes hold at once. */
final class KeysPage extends JPanel {
    private static final long serialVersionUID = 1;
    private final transient EditorSession session;
    private final transient List<EditorCommand> commands;
    private final KeyTable model;
    private final JTable table;
    /** The line that has the keyboard while a key is waited for. */
    private final JLabel capture = new JLabel();

    /** Receives the next key; {@code null} if none is waited for. */
    private transient Consumer<Optional<KeyText>> waiting;

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
        arrangeCapture();
        add(capture, "wmin 0");
        add(conflicts, "wmin 0");
        add(buttons(language));
        refresh(null);
    }

    private JTextField filter(Language language) {
        JTextField filter = new JTextField();
        filter.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, PageText.FILTER.in(language));
        filter.getAccessibleContext().setAccessibleName(PageText.FILTER.in(language));
        Listeners.onText(filter, () -> model.filter(filter.getText()));
        return filter;
    }

    private void arrangeTable(Language language) {
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setRowHeight(UIScale.scale(24));
        table.setFillsViewportHeight(true);
        table.setPreferredScrollableViewportSize(new Dimension(UIScale.scale(740), UIScale.scale(380)));
        table.setDefaultRenderer(Object.class, cells());
        table.getAccessibleContext().setAccessibleName(PageText.KEYS.in(language));
        int[] widths = {240, 104, 176, 220};
        for (int i = 0; i < widths.length; i++) {
            table.getColumnModel().getColumn(i).setPreferredWidth(UIScale.scale(widths[i]));
        }
        Listeners.onKey(table, "ENTER", () -> await(this::replace));
        Listeners.onKey(table, "DELETE", () -> change(this::remove));
    }

    private TableCellRenderer cells() {
        return new DefaultTableCellRenderer() {
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
        };
    }

    private void arrangeCapture() {
        capture.setFocusable(true);
        capture.setFocusTraversalKeysEnabled(false);
        capture.addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent event) {
                pressed(event);
            }
        });
    }

    private JPanel buttons(Language language) {
        JPanel row = new JPanel(new MigLayout("insets 0, gap 6", "[][][][]push[]"));
        button(row, PageText.REPLACE.in(language), () -> await(this::replace));
        button(row, PageText.ADD.in(language), () -> await(this::add));
        button(row, PageText.REMOVE.in(language), () -> change(this::remove));
        button(row, PageText.RESET.in(language), () -> change(this::reset));
        button(row, PageText.RESET_ALL.in(language), () -> {
            choose(Map.of());
            refresh(selected().orElse(null));
        });
        return row;
    }

    private static void button(JPanel row, String text, Runnable run) {
        JButton button = new JButton(text);
        button.addActionListener(event -> run.run());
        row.add(button);
    }

    /** Returns the keys in use. */
    private EditorKeys keys() {
        return new EditorKeys(commands, session.settings().get(EditorSetting.KEYS));
    }

    /** Binds exactly these keys to a command; its defaults leave no entry in the settings. */
    private void bind(EditorCommand command, List<KeyText> keys) {
        Map<String, List<String>> chosen =
                new LinkedHashMap<>(session.settings().get(EditorSetting.KEYS));
        List<KeyText> defaults = command.keys().stream()
                .flatMap(text -> KeyText.parse(text).stream())
                .toList();
        if (keys.equals(defaults)) {
            chosen.remove(command.id());
        } else {
            chosen.put(command.id(), keys.stream().map(KeyText::text).toList());
        }
        choose(chosen);
    }

    /** Binds one more key to a command; the oldest goes if there are too many. */
    private void add(EditorCommand command, KeyText key) {
        List<KeyText> all = Stream.concat(keys().of(command.id()).stream(), Stream.of(key))
                .distinct()
                .toList();
        bind(command, all.subList(Math.max(0, all.size() - EditorSetting.MOST_KEYS), all.size()));
    }

    private void reset(EditorCommand command) {
        Map<String, List<String>> chosen =
                new LinkedHashMap<>(session.settings().get(EditorSetting.KEYS));
        chosen.remove(command.id());
        choose(chosen);
    }

    private void choose(Map<String, List<String>> chosen) {
        session.settings(session.settings().with(EditorSetting.KEYS, chosen));
    }

    private Optional<EditorCommand> selected() {
        return table.getSelectedRow() < 0 ? Optional.empty() : Optional.of(model.command(table.getSelectedRow()));
    }

    private void replace(EditorCommand command, KeyText key) {
        bind(command, List.of(key));
    }

    private void remove(EditorCommand command) {
        bind(command, List.of());
    }

    private void change(Consumer<EditorCommand> change) {
        selected().ifPresent(command -> {
            change.accept(command);
            refresh(command);
        });
    }

    /** Waits for a key, and changes the selected command with it. */
    private void await(BiConsumer<EditorCommand, KeyText> change) {
        selected().ifPresent(command -> {
            Language language = session.language();
            capture.setText(PageText.PRESS.with(command.title().in(language)).in(language));
            capture.requestFocusInWindow();
            waiting = key -> {
                key.ifPresent(pressed -> change.accept(command, pressed));
                refresh(command);
                table.requestFocusInWindow();
            };
        });
    }

    /** Takes a key for what waits for one: Tab and Enter are keys like all others for it, Esc gives up. */
    private void pressed(KeyEvent event) {
        if (waiting == null) {
            return;
        }
        boolean isEnd = event.getKeyCode() == KeyEvent.VK_ESCAPE;
        Optional<KeyText> key = isEnd ? Optional.empty() : KeyText.pressed(event);
        event.consume();
        if (isEnd || key.isPresent()) {
            Consumer<Optional<KeyText>> taken = waiting;
            waiting = null;
            taken.accept(key);
        }
    }

    /** @param selected stays selected; {@code null} for the first */
    private void refresh(EditorCommand selected) {
        Language language = session.language();
        model.show(keys(), language);
        int row = selected == null ? 0 : model.row(selected);
        if (row >= 0 && row < model.getRowCount()) {
            table.setRowSelectionInterval(row, row);
        }
        capture.setText(PageText.HOW.in(language));
        int count = keys().conflicts().size();
        conflicts.setText(
                count == 0
                        ? PageText.NO_CONFLICTS.in(language)
                        : PageText.CONFLICTS.with(count).in(language));
        conflicts.setForeground(count == 0 ? UIManager.getColor("Label.foreground") : DialogFrame.errorColour());
    }

    JTable table() {
        return table;
    }

    JLabel capture() {
        return capture;
    }
}
