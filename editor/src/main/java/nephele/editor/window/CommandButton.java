package nephele.editor.window;

import javax.swing.AbstractButton;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.editor.widget.ToolIcons;
import nephele.engine.level.Language;

/** A button of a toolbar that runs a command: a symbol, with title and key as tooltip. */
record CommandButton(EditorCommand command, AbstractButton button) {
    /** Dresses a button for a command. */
    static CommandButton of(EditorCommand command, AbstractButton button, EditorKeys keys, Language language) {
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
        button.getAccessibleContext().setAccessibleDescription(command.title().in(language));
        button.addActionListener(event -> command.run());
        return new CommandButton(command, button);
    }

    /** Shows whether the command is possible and whether its choice holds. */
    void refresh() {
        button.setEnabled(command.isEnabled().getAsBoolean());
        button.setSelected(command.isChosen().getAsBoolean());
    }
}
