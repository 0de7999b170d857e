package nephele.editor.window.dialog;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.SwingUtilities;
import nephele.editor.widget.Listeners;

/** Shows a panel in a dialogue over the window of a component, and waits until it is closed; Esc closes it. */
public final class DialogFrame implements DialogOpener {
    private static final Color ERROR_ON_DARK = new Color(0xff8a80);
    private static final Color ERROR_ON_LIGHT = new Color(0xb3261e);

    private final Component owner;

    public DialogFrame(Component owner) {
        this.owner = owner;
    }

    /**
     * The content of a dialogue.
     *
     * @param first takes the keyboard
     * @param main the button of Enter; {@code null} for none
     */
    public record Content(JComponent panel, JComponent first, JButton main) {}

    /** Returns the colour of texts that report an error, legible in the theme in use. */
    public static Color errorColour() {
        return FlatLaf.isLafDark() ? ERROR_ON_DARK : ERROR_ON_LIGHT;
    }

    @Override
    public void open(String title, Function<Runnable, Content> making) {
        Component before = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        JDialog dialog = new JDialog(SwingUtilities.getWindowAncestor(owner), title, ModalityType.APPLICATION_MODAL);
        Content content = making.apply(dialog::dispose);
        dialog.setContentPane(content.panel());
        dialog.getRootPane().setDefaultButton(content.main());
        Listeners.onKey(dialog.getRootPane(), "ESCAPE", dialog::dispose);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                content.first().requestFocusInWindow();
            }
        });
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.pack();
        Dimension screen = dialog.getToolkit().getScreenSize();
        dialog.setSize(Math.min(dialog.getWidth(), screen.width), Math.min(dialog.getHeight(), screen.height));
        dialog.setLocationRelativeTo(owner);
        dialog.setVisible(true);
        // Not every window system gives the keyboard back by itself.
        if (before != null) {
            before.requestFocus();
        }
    }
}
