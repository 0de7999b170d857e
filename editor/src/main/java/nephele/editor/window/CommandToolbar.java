package nephele.editor.window;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.widget.ToolIcons;
import nephele.engine.level.Language;

/** The toolbar: main actions and all tools as symbols, with title and key as tooltip. */
final class CommandToolbar extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient List<CommandButton> buttons = new ArrayList<>();

    CommandToolbar() {
        super(new WrappingRow());
        setBorder(BorderFactory.createEmptyBorder(2, 4, 2, 4));
    }

    /** Fills the toolbar anew. */
    void fill(EditorCommands commands, List<String> mainActions, EditorKeys keys, Language language) {
        removeAll();
        buttons.clear();
        getAccessibleContext().setAccessibleName(WindowText.TOOLS.in(language));
        for (String id : mainActions) {
            commands.named(id).ifPresent(command -> add(command, new JButton(), keys, language));
        }
        if (!buttons.isEmpty()) {
            add(separator());
        }
        commands.all().stream()
                .filter(EditorCommand::isTool)
                .forEach(command -> add(command, new JToggleButton(), keys, language));
        refresh();
        revalidate();
        repaint();
    }

    private static JComponent separator() {
        JSeparator line = new JSeparator(SwingConstants.VERTICAL);
        line.setPreferredSize(new Dimension(
                line.getPreferredSize().width * 3, ToolIcons.of("select", "").getIconHeight()));
        return line;
    }

    private void add(EditorCommand command, AbstractButton button, EditorKeys keys, Language language) {
        buttons.add(CommandButton.of(command, button, keys, language));
        button.addActionListener(event -> refresh());
        add(button);
    }

    /** Shows what is possible and which tool is in use. */
    void refresh() {
        buttons.forEach(CommandButton::refresh);
    }
}
