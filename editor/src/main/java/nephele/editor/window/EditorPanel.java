package nephele.editor.window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JMenuBar;
import javax.swing.JPanel;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.document.Registration;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import nephele.editor.window.viewport.ViewportPanel;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;

/** The whole editor as one component: menus, toolbar, viewport between slots, status bar. It needs no display. */
public final class EditorPanel extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1;

    private final transient EditorSession session;
    private final transient EditorCommands commands;
    private final transient EditorSlots slots;
    private final JMenuBar menus = new JMenuBar();
    private final CommandToolbar toolbar = new CommandToolbar();
    private final OptionBar options;
    private final StatusBar status;
    private final ViewportPanel viewport;
    private final transient List<Registration> registrations = new ArrayList<>();
    private transient EditorKeys keys;

    /** Creates a panel that follows the session. */
    public EditorPanel(EditorSession session, EditorCommands commands, EditorSlots slots) {
        super(new BorderLayout());
        this.session = session;
        this.commands = commands;
        this.slots = slots;
        session.background().runOn(new WaitingLoop(() -> session.status(WindowText.READING.words())));
        options = new OptionBar(session, commands);
        status = new StatusBar(session);
        viewport = new ViewportPanel(session, this::pointed, line -> session.status(Words.same(line)));
        SlotLayout middle =
                new SlotLayout(under(slots.top()), slots, session.settings().get(EditorSetting.SPLITTERS));
        JPanel top = new JPanel(new BorderLayout());
        top.add(menus, BorderLayout.PAGE_START);
        top.add(toolbar, BorderLayout.CENTER);
        top.add(options, BorderLayout.PAGE_END);
        add(top, BorderLayout.PAGE_START);
        add(middle, BorderLayout.CENTER);
        add(status, BorderLayout.PAGE_END);
        // The height of the toolbar follows from its width.
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                toolbar.revalidate();
                options.revalidate();
            }
        });
        fill();
        registrations.add(session.listen(this::follow));
    }

    private JComponent under(JComponent top) {
        if (top == null) {
            return viewport;
        }
        JPanel both = new JPanel(new BorderLayout());
        both.add(top, BorderLayout.PAGE_START);
        both.add(viewport, BorderLayout.CENTER);
        return both;
    }

    private void pointed(Optional<Vec3> place) {
        status.pointed(place);
        session.proving().pointed(place);
    }

    private void follow(SessionChange change) {
        if (change == SessionChange.SETTINGS) {
            fill();
        }
        status.refresh();
        if (change != SessionChange.STATUS) {
            toolbar.refresh();
            options.refresh();
        }
    }

    /** Makes menus, tooltips and keys anew, in the session's language. */
    private void fill() {
        keys = new EditorKeys(commands.all(), session.settings().get(EditorSetting.KEYS));
        Language language = session.language();
        CommandMenus.fill(menus, commands, keys, language);
        toolbar.fill(commands, slots.mainActions(), keys, language);
        options.fill(keys);
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

    /** Lays this out at a size; without a display nothing else does. */
    public void layOut(Dimension size) {
        setSize(size);
        // The second pass knows the widths that the first one gave, the third the splitters that follow from them.
        for (int pass = 0; pass < 3; pass++) {
            invalidate(this);
            layOut(this);
        }
    }

    private static void invalidate(Container container) {
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                invalidate(inner);
            }
        }
        container.invalidate();
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** Paints this, laid out before, after the viewport was drawn with all edits taken over. */
    public BufferedImage picture() {
        viewport.picture();
        return pictureAsShown();
    }

    /** Paints this as it is shown: the viewport with its last picture, which waits for nothing. */
    BufferedImage pictureAsShown() {
        BufferedImage picture =
                new BufferedImage(Math.max(1, getWidth()), Math.max(1, getHeight()), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        try {
            printAll(graphics);
        } finally {
            graphics.dispose();
        }
        return picture;
    }

    /** Closes a registration together with the panel. */
    public void closeToo(Registration registration) {
        registrations.add(registration);
    }

    /** Closes the viewport and every closeable panel in the slots; nothing here follows the session any more. */
    @Override
    public void close() {
        registrations.forEach(Registration::close);
        closeAll(this);
    }

    private static void closeAll(Container container) {
        for (Component child : container.getComponents()) {
            if (child instanceof AutoCloseable part) {
                close(part);
            } else if (child instanceof Container inner) {
                closeAll(inner);
            }
        }
    }

    private static void close(AutoCloseable part) {
        try {
            part.close();
        } catch (RuntimeException failure) {
            throw failure;
        } catch (Exception checked) {
            throw new IllegalStateException(part + " can't be closed", checked);
        }
    }
}
