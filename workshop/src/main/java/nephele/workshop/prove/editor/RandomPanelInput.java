package nephele.workshop.prove.editor;

import java.awt.Component;
import java.awt.Container;
import java.awt.HeadlessException;
import java.awt.IllegalComponentStateException;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/** Random input to what surrounds the viewport: clicks, keys that components bind, texts, choices. */
final class RandomPanelInput {
    private static final List<String> TEXTS = List.of(
            "",
            "0",
            "-1",
            "2.5",
            "1e9",
            "-0",
            "NaN",
            "3*2+1",
            "1/0",
            "abc",
            "ção",
            "size>4",
            "material:brick",
            "portalable:true size>",
            "\"",
            "solid",
            "1,2,3",
            "   ",
            "(((",
            "red",
            "long ".repeat(40));

    private final Container root;
    private final SplittableRandom random;
    private final List<String> leftOut;
    private String last = "";

    /** @param leftOut names of components that receive nothing */
    RandomPanelInput(Container root, SplittableRandom random, List<String> leftOut) {
        this.root = root;
        this.random = random;
        this.leftOut = leftOut;
    }

    /** Returns the last receiver in words. */
    String last() {
        return last;
    }

    /** Sends an event to a random component. */
    void send() {
        int how = random.nextInt(8);
        Component at =
                how < 2 ? any(RandomPanelInput::isInput) : how < 4 ? any(RandomPanelInput::isButton) : anyPlace();
        last = "nothing";
        if (at == null || leftOut.contains(String.valueOf(at.getName())) || at instanceof JMenu) {
            return;
        }
        last = at.getClass().getSimpleName() + " " + at.getName() + " " + at.getBounds();
        try {
            send(at);
        } catch (HeadlessException | IllegalComponentStateException noScreen) {
            // A popup or the system's clipboard, which need a screen.
            last = "without a screen: " + last;
        }
    }

    private void send(Component at) {
        JComboBox<?> choice = at instanceof JComboBox<?> box
                ? box
                : (JComboBox<?>) SwingUtilities.getAncestorOfClass(JComboBox.class, at);
        if (choice != null) {
            if (choice.isEnabled() && choice.getItemCount() > 0) {
                choice.setSelectedIndex(random.nextInt(choice.getItemCount()));
            }
        } else if (at instanceof JTextComponent text) {
            // Its keys move a caret, which the toolkit can do only on a screen.
            write(text);
        } else if (at instanceof JTabbedPane tabs && tabs.getTabCount() > 0) {
            tabs.setSelectedIndex(random.nextInt(tabs.getTabCount()));
        } else if (at instanceof JComponent component && !(at instanceof JSplitPane) && random.nextInt(3) == 0) {
            boundKey(component);
        } else {
            click(at);
        }
    }

    private Component anyPlace() {
        int x = random.nextInt(Math.max(1, root.getWidth()));
        int y = random.nextInt(Math.max(1, root.getHeight()));
        return SwingUtilities.getDeepestComponentAt(root, x, y);
    }

    /** Returns a component of a kind that a random place would seldom hit; {@code null} for none. */
    private Component any(Predicate<Component> wanted) {
        List<Component> found = new ArrayList<>();
        add(root, wanted, found);
        return found.isEmpty() ? null : found.get(random.nextInt(found.size()));
    }

    private static boolean isInput(Component each) {
        return each instanceof JTextComponent || each instanceof JComboBox;
    }

    private static boolean isButton(Component each) {
        return each instanceof AbstractButton && each.isEnabled();
    }

    private static void add(Container container, Predicate<Component> wanted, List<Component> found) {
        for (Component child : container.getComponents()) {
            if (wanted.test(child)) {
                found.add(child);
            } else if (child instanceof Container inner && child.isVisible()) {
                add(inner, wanted, found);
            }
        }
    }

    private void write(JTextComponent text) {
        if (!text.isEditable() || !text.isEnabled()) {
            return;
        }
        text.dispatchEvent(new FocusEvent(text, FocusEvent.FOCUS_GAINED));
        text.setText(TEXTS.get(random.nextInt(TEXTS.size())));
        if (text instanceof JTextField field && random.nextBoolean()) {
            field.postActionEvent();
        }
        text.dispatchEvent(new FocusEvent(text, FocusEvent.FOCUS_LOST));
    }

    private void boundKey(JComponent component) {
        KeyStroke[] strokes = component.getRegisteredKeyStrokes();
        if (strokes.length == 0) {
            return;
        }
        KeyStroke stroke = strokes[random.nextInt(strokes.length)];
        component
                .getActionForKeyStroke(stroke)
                .actionPerformed(
                        new java.awt.event.ActionEvent(component, java.awt.event.ActionEvent.ACTION_PERFORMED, "\n"));
    }

    private void click(Component at) {
        int x = random.nextInt(Math.max(1, at.getWidth()));
        int y = random.nextInt(Math.max(1, at.getHeight()));
        int clicks = 1 + random.nextInt(2);
        int modifiers = random.nextInt(4) == 0 ? InputEvent.CTRL_DOWN_MASK : 0;
        for (int id : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED, MouseEvent.MOUSE_CLICKED}) {
            int mask = id == MouseEvent.MOUSE_PRESSED ? InputEvent.BUTTON1_DOWN_MASK : 0;
            at.dispatchEvent(new MouseEvent(at, id, 0, modifiers | mask, x, y, clicks, false, MouseEvent.BUTTON1));
        }
    }
}
