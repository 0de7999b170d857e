package nephele.editor.window;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.KeyText;
import nephele.engine.level.Language;

/** Makes the menu bar from the commands; a menu without commands is left out. */
final class CommandMenus {
    private CommandMenus() {}

    /** Fills a menu bar anew. */
    static void fill(JMenuBar bar, EditorCommands commands, EditorKeys keys, Language language) {
        bar.removeAll();
        for (Menu menu : Menu.values()) {
            List<EditorCommand> members = commands.in(menu);
            if (!members.isEmpty()) {
                bar.add(menu(menu, members, keys, language));
            }
        }
        bar.revalidate();
        bar.repaint();
    }

    private static JMenu menu(Menu menu, List<EditorCommand> members, EditorKeys keys, Language language) {
        JMenu made = new JMenu(menu.title().in(language));
        for (EditorCommand command : members) {
            made.add(item(command, keys, language));
        }
        made.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent event) {
                refresh(made, members);
            }

            @Override
            public void menuDeselected(MenuEvent event) {
                // Items are enabled anew when the menu opens.
            }

            @Override
            public void menuCanceled(MenuEvent event) {
                // As above.
            }
        });
        return made;
    }

    private static JMenuItem item(EditorCommand command, EditorKeys keys, Language language) {
        JMenuItem item = new JCheckBoxMenuItem() {
            private static final long serialVersionUID = 1;

            /**
             * Shows the key but does not react to it: {@code EditorKeys} finds commands by keys, so that a letter typed
             * into a text field starts none.
             */
            @Override
            protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean isPressed) {
                return false;
            }
        };
        item.setText(command.title().in(language));
        item.setName(command.id());
        keys.of(command.id()).stream().findFirst().map(KeyText::stroke).ifPresent(item::setAccelerator);
        item.addActionListener(event -> command.run());
        return item;
    }

    private static void refresh(JMenu menu, List<EditorCommand> members) {
        for (int i = 0; i < members.size(); i++) {
            menu.getItem(i).setEnabled(members.get(i).isEnabled().getAsBoolean());
            menu.getItem(i).setSelected(members.get(i).isChosen().getAsBoolean());
        }
    }
}
