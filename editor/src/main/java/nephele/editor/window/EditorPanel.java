package nephele.editor.window;

import java.awt.BorderLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.util.Map;
import java.util.Optional;
import javax.swing.JMenuBar;
import javax.swing.JPanel;
import nephele.editor.command.EditorCommands;
import nephele.editor.command.EditorKeys;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.settings.EditorSetting;
import nephele.editor.surface.SurfaceMode;
import nephele.editor.text.Words;
import nephele.editor.window.viewport.ViewportPanel;
import nephele.editor.window.viewport.ViewportPanel.Told;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;

/**
 * The whole editor as one component: menus, toolbar, viewport between slots, status bar. It needs no display if its
 * surface is offscreen.
 */
public final class EditorPanel extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1;

    private final transient EditorSession session;
    private final transient EditorCommands commands;
    private final transient EditorSlots slots;
    private final JMenuBar menus = new JMenuBar();
    private final CommandToolbar toolbar = new CommandToolbar();
    private final StatusBar status;
    private final ViewportPanel viewport;
    private final SlotLayout middle;
    private transient EditorKeys keys;

    /** Creates a panel that follows the session. */
    public EditorPanel(EditorSession session, EditorCommands commands, SurfaceMode mode, EditorSlots slots) {
        super(new BorderLayout());
        this.session = session;
        this.commands = commands;
        this.slots = slots;
        status = new StatusBar(session);
        viewport = new ViewportPanel(session, mode, new Told(this::pointed, line -> session.status(Words.same(line))));
        middle = new SlotLayout(viewport, slots, session.settings().get(EditorSetting.SPLITTERS));
        JPanel top = new JPanel(new BorderLayout());
        top.add(menus, BorderLayout.PAGE_START);
        top.add(toolbar, BorderLayout.CENTER);
        add(top, BorderLayout.PAGE_START);
        add(middle, BorderLayout.CENTER);
        add(status, BorderLayout.PAGE_END);
        // The height of the toolbar follows from its width.
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                toolbar.revalidate();
            }
        });
        fill();
        session.listen(this::follow);
    }

    private void pointed(Optional<Vec3> place) {
        status.pointed(place);
        session.proving().pointed(place);
    }

    private void follow(Change change) {
        if (change == Change.SETTINGS) {
            fill();
        }
        status.refresh();
        if (change != Change.STATUS) {
            toolbar.refresh();
        }
    }

    /** Makes menus, tooltips and keys anew, in the session's language. */
    private void fill() {
        keys = new EditorKeys(commands.all(), session.settings().get(EditorSetting.KEYS));
        Language language = session.language();
        CommandMenus.fill(menus, commands, keys, language);
        toolbar.fill(commands, slots.mainActions(), keys, language);
    }

    /** Returns the keys in use. */
    public EditorKeys keys() {
        return keys;
    }

    public EditorCommands commands() {
        return commands;
    }

    public ViewportPanel viewport() {
        return viewport;
    }

    /** Returns the places of the splitters by name, for {@link EditorSetting#SPLITTERS}. */
    public Map<String, Double> splitters() {
        return middle.shares();
    }

    /**
     * Takes a key that was pressed anywhere in the window: for the viewport's drag or flight, or for a command.
     *
     * @return false if it means nothing here
     */
    public boolean key(KeyEvent event) {
        if (viewport.key(event)) {
            return true;
        }
        if (event.getID() != KeyEvent.KEY_PRESSED) {
            return false;
        }
        Optional<String> found = keys.find(event);
        found.flatMap(commands::named).ifPresent(command -> command.run());
        return found.isPresent();
    }

    @Override
    public void close() {
        viewport.close();
    }
}
