package nephele.editor.window;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.ListSelectionModel;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import nephele.editor.command.CommandSearch;
import nephele.editor.command.EditorCommand;
import nephele.editor.command.EditorKeys;
import nephele.editor.command.KeyText;
import nephele.engine.level.Language;
import net.miginfocom.swing.MigLayout;

/** A search over all commands: words narrow the list, Enter runs the chosen one. */
public final class CommandPalette extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int ROWS = 12;

    private final JTextField query = new JTextField(32);
    private final DefaultListModel<EditorCommand> found = new DefaultListModel<>();
    private final JList<EditorCommand> list = new JList<>(found);
    private final transient List<EditorCommand> commands;
    private final transient EditorKeys keys;
    private final transient Language language;
    private final transient Consumer<Optional<EditorCommand>> done;

    /** @param done receives the command to run, or nothing if the user cancels */
    public CommandPalette(
            List<EditorCommand> commands, EditorKeys keys, Language language, Consumer<Optional<EditorCommand>> done) {
        super(new BorderLayout(0, 6));
        this.commands = commands;
        this.keys = keys;
        this.language = language;
        this.done = done;
        setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
        query.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, WindowText.SEARCH.in(language));
        query.getAccessibleContext().setAccessibleName(WindowText.SEARCH.in(language));
        query.getDocument().addDocumentListener(new Refind());
        query.addKeyListener(new Choosing());
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer((all, command, index, isSelected, hasFocus) -> row(command, isSelected));
        list.setVisibleRowCount(ROWS);
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                choose();
            }
        });
        add(query, BorderLayout.PAGE_START);
        add(new JScrollPane(list));
        refind();
    }

    private final class Refind implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent event) {
            refind();
        }

        @Override
        public void removeUpdate(DocumentEvent event) {
            refind();
        }

        @Override
        public void changedUpdate(DocumentEvent event) {
            refind();
        }
    }

    private final class Choosing extends KeyAdapter {
        @Override
        public void keyPressed(KeyEvent event) {
            switch (event.getKeyCode()) {
                case KeyEvent.VK_ENTER -> choose();
                case KeyEvent.VK_ESCAPE -> done.accept(Optional.empty());
                case KeyEvent.VK_DOWN -> step(1);
                case KeyEvent.VK_UP -> step(-1);
                default -> {
                    return;
                }
            }
            event.consume();
        }
    }

    private void refind() {
        found.clear();
        CommandSearch.find(commands, query.getText(), language).forEach(found::addElement);
        list.setSelectedIndex(0);
    }

    private void step(int rows) {
        int next = Math.max(0, Math.min(found.size() - 1, list.getSelectedIndex() + rows));
        list.setSelectedIndex(next);
        list.ensureIndexIsVisible(next);
    }

    private void choose() {
        EditorCommand chosen = list.getSelectedValue();
        if (chosen != null && chosen.isEnabled().getAsBoolean()) {
            done.accept(Optional.of(chosen));
        }
    }

    private Component row(EditorCommand command, boolean isSelected) {
        JPanel row = new JPanel(new MigLayout("insets 3 6 3 6, fillx", "[][]push[]"));
        row.setBackground(isSelected ? list.getSelectionBackground() : list.getBackground());
        JLabel title = new JLabel(command.title().in(language));
        JLabel menu = new JLabel(command.menu().title().in(language));
        JLabel key = new JLabel(
                keys.of(command.id()).stream().findFirst().map(KeyText::text).orElse(""));
        for (JLabel label : List.of(title, menu, key)) {
            label.setForeground(isSelected ? list.getSelectionForeground() : list.getForeground());
            row.add(label);
        }
        title.setEnabled(command.isEnabled().getAsBoolean());
        menu.setEnabled(isSelected);
        return row;
    }

    /** Returns the field for the search words. */
    public JTextField query() {
        return query;
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return new Dimension(Math.max(size.width, query.getPreferredSize().width + 16), size.height);
    }
}
