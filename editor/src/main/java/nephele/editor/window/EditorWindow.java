package nephele.editor.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import javax.swing.text.JTextComponent;
import nephele.editor.document.Registration;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.session.SessionChange;

/** The window of an editor. It follows theme, scale and language of the settings while it is open. */
public final class EditorWindow extends JFrame {
    private static final long serialVersionUID = 1;

    private final transient EditorSession session;
    private final EditorPanel panel;
    private final transient Closing closing;
    private final transient Runnable closed;
    private final transient KeyEventDispatcher keys = this::sendKey;
    private final transient Registration registration;
    private transient EditorSettings look;

    /**
     * Creates a window, not yet visible; {@link WindowLook#apply} has to come before the panel is made.
     *
     * @param closed called after the window was closed, such as to keep its settings
     */
    public EditorWindow(
            EditorSession session, EditorPanel panel, WindowInterface ui, Closing closing, Runnable closed) {
        this.session = session;
        this.panel = panel;
        this.closing = closing;
        this.closed = closed;
        look = session.settings();
        ui.attach(this);
        add(panel);
        setSize(fitting(1280, 800));
        setLocationByPlatform(true);
        setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                closeIfAllowed();
            }
        });
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(keys);
        registration = session.listen(this::follow);
        setTitle(title(session));
    }

    /** Returns a size in points of text at the scale of the settings, at most that of the screen without its bars. */
    private static Dimension fitting(int width, int height) {
        Dimension screen = GraphicsEnvironment.getLocalGraphicsEnvironment()
                .getMaximumWindowBounds()
                .getSize();
        return new Dimension(
                Math.min(UIScale.scale(width), screen.width), Math.min(UIScale.scale(height), screen.height));
    }

    private void follow(SessionChange change) {
        if (change == SessionChange.SETTINGS && WindowLook.differs(look, session.settings())) {
            look = session.settings();
            WindowLook.apply(look);
            SwingUtilities.updateComponentTreeUI(this);
        }
        String title = title(session);
        if (!title.equals(getTitle())) {
            setTitle(title);
        }
    }

    /** Sends a key of this window to its editor, unless the component that has the focus needs it itself. */
    private boolean sendKey(KeyEvent event) {
        Component focus = event.getComponent();
        boolean isElsewhere = focus == null
                || focus != this && SwingUtilities.getWindowAncestor(focus) != this
                || MenuSelectionManager.defaultManager().getSelectedPath().length > 0;
        return !isElsewhere && !belongsTo(focus, event) && panel.key(event);
    }

    /** Returns true if a component has a use for a key of its own. */
    static boolean belongsTo(Component focus, KeyEvent event) {
        boolean isPlain = !event.isControlDown() && !event.isAltDown() && !event.isMetaDown();
        boolean isFunction = event.getKeyCode() >= KeyEvent.VK_F1 && event.getKeyCode() <= KeyEvent.VK_F12;
        if (focus instanceof JTextComponent && isPlain && !isFunction) {
            return true;
        }
        boolean mayBind = focus instanceof JTextComponent || isPlain;
        return mayBind && focus instanceof JComponent component && isBound(component, event);
    }

    private static boolean isBound(JComponent component, KeyEvent event) {
        KeyStroke stroke = KeyStroke.getKeyStrokeForEvent(event);
        return component.getInputMap(JComponent.WHEN_FOCUSED).get(stroke) != null
                || component
                                .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                                .get(stroke)
                        != null;
    }

    /** Comes to the front, with the keyboard. */
    public void takeKeyboard() {
        toFront();
        panel.viewport().surface().requestFocus();
    }

    /** Returns what the window shows. */
    public EditorPanel panel() {
        return panel;
    }

    /** Closes the window if the user agrees to lose nothing; returns false if it stays. */
    public boolean closeIfAllowed() {
        if (!closing.isAllowed()) {
            return false;
        }
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
        registration.close();
        panel.close();
        dispose();
        closed.run();
        return true;
    }

    /** Returns the level's file name, or a word for none. */
    static String name(EditorSession session) {
        return session.file()
                .path()
                .map(Path::getFileName)
                .map(Path::toString)
                .orElseGet(() -> WindowText.UNTITLED.in(session.language()));
    }

    /** Returns the title, with an asterisk if something is not saved. */
    static String title(EditorSession session) {
        String mark = session.document().isModified() ? "*" : "";
        return mark + name(session) + " – " + WindowText.TITLE.in(session.language());
    }
}
