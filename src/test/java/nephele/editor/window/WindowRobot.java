package nephele.editor.window;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.File;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;

/** A user of a window in this process: real mouse and keys, and pictures of the display. */
public final class WindowRobot {
    private static final long LONGEST_NANOS = 60_000_000_000L;
    private static final int STEP_MILLIS = 25;
    private static final int HOLD_MILLIS = 20;

    private final Robot robot = new Robot();
    private final File pictures;
    private final Supplier<String> state;

    /**
     * @param pictures folder of the pictures
     * @param state what to tell if something is waited for in vain
     */
    public WindowRobot(File pictures, Supplier<String> state) throws Exception {
        this.pictures = pictures;
        this.state = state;
        pictures.mkdirs();
    }

    /** Returns an answer of the event dispatch thread. */
    public static <T> T asked(Supplier<T> question) throws Exception {
        Object[] answer = new Object[1];
        EventQueue.invokeAndWait(() -> answer[0] = question.get());
        @SuppressWarnings("unchecked")
        T typed = (T) answer[0];
        return typed;
    }

    /** Waits until a condition holds on the event dispatch thread. */
    public void await(String what, BooleanSupplier condition) throws Exception {
        await(what, () -> {}, condition);
    }

    private void await(String what, Attempt attempt, BooleanSupplier condition) throws Exception {
        long start = System.nanoTime();
        for (attempt.make(); !asked(condition::getAsBoolean); attempt.make()) {
            if (System.nanoTime() - start > LONGEST_NANOS) {
                picture("in-vain");
                throw new IllegalStateException("waited in vain for " + what + "; " + state.get());
            }
            robot.delay(STEP_MILLIS);
        }
    }

    /** What is done before each look at a condition. */
    private interface Attempt {
        void make() throws Exception;
    }

    /** Returns the visible dialogue; {@code null} for none. */
    public static JDialog dialog() {
        return (JDialog) Arrays.stream(Window.getWindows())
                .filter(window -> window instanceof JDialog && window.isShowing())
                .findFirst()
                .orElse(null);
    }

    /** Returns the first component that fits, of all visible windows. */
    public static Optional<Component> find(Predicate<Component> wanted) {
        return Arrays.stream(Window.getWindows())
                .filter(Component::isShowing)
                .map(window -> in(window, wanted))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private static Optional<Component> in(Container container, Predicate<Component> wanted) {
        for (Component child : container.getComponents()) {
            Optional<Component> found = wanted.test(child) && child.isShowing()
                    ? Optional.of(child)
                    : child instanceof Container deeper ? in(deeper, wanted) : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    /** Clicks on the button with a text, of a dialogue if there is one. */
    public void clickButton(String text) throws Exception {
        Predicate<Component> wanted = child -> child instanceof AbstractButton button && text.equals(button.getText());
        await("the button " + text, () -> find(wanted).isPresent());
        // A click before the display shows the window would go to the one behind it, and a window that opened under the
        // pointer notices it only when it comes back.
        await(
                "the pointer on " + text,
                () -> {
                    robot.mouseMove(0, 0);
                    asked(() -> find(wanted).map(WindowRobot::settled));
                    moveTo(asked(() -> find(wanted).map(WindowRobot::middle).orElse(new Point())));
                },
                () -> find(wanted).filter(WindowRobot::isPointedAt).isPresent());
        press();
    }

    /**
     * Moves the dialogue of a button by a pixel. Without a window manager the toolkit may take a new dialogue to be in
     * the corner of the display, where it is not; a move makes both agree.
     */
    private static Component settled(Component button) {
        if (SwingUtilities.getWindowAncestor(button) instanceof JDialog dialog) {
            dialog.setLocation(dialog.getX() + 1, dialog.getY());
        }
        return button;
    }

    private static Point middle(Component button) {
        if (button.getParent() instanceof javax.swing.JComponent parent) {
            parent.scrollRectToVisible(button.getBounds());
        }
        Point at = button.getLocationOnScreen();
        at.translate(button.getWidth() / 2, button.getHeight() / 2);
        return at;
    }

    /** Clicks on the tab with a title. */
    public void clickTab(String title) throws Exception {
        Predicate<Component> wanted =
                child -> child instanceof JTabbedPane tabs && tabs.indexOfTab(title) >= 0 && tabs.isShowing();
        await("the tab " + title, () -> find(wanted).isPresent());
        click(asked(() -> {
            JTabbedPane tabs = (JTabbedPane) find(wanted).orElseThrow();
            Rectangle tab = tabs.getBoundsAt(tabs.indexOfTab(title));
            Point at = tabs.getLocationOnScreen();
            at.translate((int) tab.getCenterX(), (int) tab.getCenterY());
            return at;
        }));
    }

    private static boolean isPointedAt(Component button) {
        return ((AbstractButton) button).getModel().isRollover();
    }

    /** Moves the pointer in two steps, because a pointer that has not moved only points with its first click. */
    public void moveTo(Point at) {
        robot.mouseMove(at.x + 3, at.y + 2);
        robot.delay(HOLD_MILLIS);
        robot.mouseMove(at.x, at.y);
        robot.delay(HOLD_MILLIS);
    }

    public void click(Point at) {
        moveTo(at);
        robot.delay(4 * STEP_MILLIS);
        press();
    }

    private void press() {
        robot.waitForIdle();
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.delay(HOLD_MILLIS);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.delay(HOLD_MILLIS);
    }

    /** Drags in ten steps. */
    public void drag(Point from, Point to) {
        moveTo(from);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        for (int i = 1; i <= 10; i++) {
            robot.mouseMove(from.x + (to.x - from.x) * i / 10, from.y + (to.y - from.y) * i / 10);
            robot.delay(HOLD_MILLIS);
        }
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.delay(HOLD_MILLIS);
    }

    /** Presses keys together, named as {@link KeyEvent} names them, such as {@code CONTROL}, {@code S}. */
    public void keys(String... names) throws ReflectiveOperationException {
        for (String name : names) {
            robot.keyPress(code(name));
            robot.delay(HOLD_MILLIS);
        }
        for (int i = names.length - 1; i >= 0; i--) {
            robot.keyRelease(code(names[i]));
        }
        robot.delay(HOLD_MILLIS);
    }

    /** Holds a key down until a condition holds. */
    public void hold(String name, BooleanSupplier until) throws Exception {
        robot.keyPress(code(name));
        try {
            await("the end of " + name, until);
        } finally {
            robot.keyRelease(code(name));
        }
    }

    /** Types lower-case letters, digits and hyphens. */
    public void type(String text) throws ReflectiveOperationException {
        for (char each : text.toCharArray()) {
            keys(each == '-' ? "MINUS" : String.valueOf(each).toUpperCase(Locale.ROOT));
        }
    }

    private static int code(String name) throws ReflectiveOperationException {
        return KeyEvent.class.getField("VK_" + name).getInt(null);
    }

    /** Returns a colour on the display. */
    public Color colour(Point at) {
        return robot.getPixelColor(at.x, at.y);
    }

    /** Writes a picture of the display, after what was done has been drawn. */
    public void picture(String name) throws Exception {
        robot.delay(200);
        Rectangle screen = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        ImageIO.write(robot.createScreenCapture(screen), "png", new File(pictures, name + ".png"));
    }
}
