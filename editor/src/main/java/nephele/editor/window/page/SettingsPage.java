package nephele.editor.window.page;

import java.awt.BorderLayout;
import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import nephele.editor.action.EditorCommand;
import nephele.editor.session.EditorSession;
import net.miginfocom.swing.MigLayout;

/** All settings of the editor: a tab of general ones, and one of the keys. */
public final class SettingsPage extends JPanel {
    private static final long serialVersionUID = 1;

    /** The tabs, in order. */
    public enum Tab {
        GENERAL,
        KEYS
    }

    private final transient EditorSession session;
    private final transient List<EditorCommand> commands;
    private final transient Path settingsFile;
    private final transient Runnable close;
    private JTabbedPane tabs;
    private KeysPage keys;

    /** @param settingsFile {@code null} if there is none */
    public SettingsPage(EditorSession session, List<EditorCommand> commands, Path settingsFile, Runnable close) {
        super(new BorderLayout());
        this.session = session;
        this.commands = commands;
        this.settingsFile = settingsFile;
        this.close = close;
        fill(Tab.GENERAL);
    }

    private void fill(Tab tab) {
        removeAll();
        keys = new KeysPage(session, commands);
        tabs = new JTabbedPane();
        tabs.addTab(PageText.GENERAL.in(session.language()), new GeneralPage(session, settingsFile, this::restyle));
        tabs.addTab(PageText.KEYS.in(session.language()), keys);
        tabs.setSelectedIndex(tab.ordinal());
        JButton end = new JButton(PageText.CLOSE.in(session.language()));
        end.addActionListener(event -> close.run());
        JPanel bottom = new JPanel(new MigLayout("insets 8 14 12 14", "push[]"));
        bottom.add(end);
        add(tabs);
        add(bottom, BorderLayout.PAGE_END);
    }

    /** Shows itself anew, in another language, theme or size. */
    private void restyle() {
        Window window = SwingUtilities.getWindowAncestor(this);
        SwingUtilities.invokeLater(() -> {
            fill(tab());
            if (window != null) {
                SwingUtilities.updateComponentTreeUI(window);
                window.pack();
            }
        });
    }

    /** Shows a tab. */
    public SettingsPage at(Tab tab) {
        tabs.setSelectedIndex(tab.ordinal());
        return this;
    }

    private Tab tab() {
        return Tab.values()[tabs.getSelectedIndex()];
    }

    /** Returns the component that takes the keyboard first. */
    public JTabbedPane tabs() {
        return tabs;
    }

    KeysPage keys() {
        return keys;
    }
}
