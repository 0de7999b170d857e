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
import nephele.editor.command.EditorCommand;
import nephele.editor.command.EditorCommands;
import nephele.editor.command.EditorKeys;
import nephele.editor.command.KeyText;
import nephele.engine.level.Language;

/** The toolbar: main actions and all tools as symbols, with title and key as tooltip. */
final class CommandToolbar extends JPanel {
    private static final long serialVersionUID = 1;

    private final transient List<Shown> shown = new ArrayList<>();

    private record Shown(EditorCommand command, AbstractButton button) {}

    CommandToolbar() {
        super(new WrappingRow());
        setBorder(BorderFactory.createEmptyBorder(2, 4, 2, 4));
    }

    /** Fills the toolbar anew. */
    void fill(EditorCommands commands, List<String> mainActions, EditorKeys keys, Language language) {
        removeAll();
        shown.clear();
        getAccessibleContext().setAccessibleName(WindowText.TOOLS.in(language));
        for (String id : mainActions) {
            commands.named(id).ifPresent(command -> add(command, new JButton(), keys, language));
        }
        if (!shown.isEmpty()) {
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
        String title = command.title().in(language);
        String key = keys.of(command.id()).stream()
                .findFirst()
                .map(KeyText::text)
                .map(text -> " (" + text + ")")
                .orElse("");
        button.setIcon(ToolIcons.of(command.id(), title));
        button.setName(command.id());
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setToolTipText(title + key);
        button.getAccessibleContext().setAccessibleName(title);
        button.getAccessibleContext()
                .setAccessibleDescription(command.description().in(language));
        button.addActionListener(event -> {
            command.run();
            refresh();
        });
        add(button);
        shown.add(new Shown(command, button));
    }

    /** Shows what is possible and which tool is in use. */
    void refresh() {
        for (Shown each : shown) {
            each.button().setEnabled(each.command().isEnabled().getAsBoolean());
            each.button().setSelected(each.command().isChosen().getAsBoolean());
        }
    }
}
