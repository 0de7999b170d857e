package nephele.app.play;

import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.BufferedReader;
import java.io.File;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;

/**
 * A program that types, clicks and takes pictures on its display, as a player would: one command a line of its input,
 * each answered by "ok". It is a process of its own because the tests' own process has no display.
 */
public final class RobotHands {
    private static final int HOLD_MS = 60;

    private final Robot robot;

    private RobotHands(Robot robot) {
        this.robot = robot;
    }

    public static void main(String[] args) throws Exception {
        var hands = new RobotHands(new Robot());
        var lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            hands.obey(line.split(" "));
            System.out.println("ok");
        }
    }

    private void obey(String[] words) throws Exception {
        switch (words[0]) {
            case "key" -> {
                robot.keyPress(code(words[1]));
                robot.delay(HOLD_MS);
                robot.keyRelease(code(words[1]));
                robot.delay(HOLD_MS);
            }
            case "down" -> robot.keyPress(code(words[1]));
            case "up" -> robot.keyRelease(code(words[1]));
            case "click" -> click(Integer.parseInt(words[1]), Integer.parseInt(words[2]));
            case "picture" -> picture(words);
            default -> throw new IllegalArgumentException(words[0]);
        }
    }

    private static int code(String key) throws ReflectiveOperationException {
        return KeyEvent.class.getField("VK_" + key).getInt(null);
    }

    /** Moves there in two steps, because a pointer that has not moved only points with its first click. */
    private void click(int x, int y) {
        robot.mouseMove(x + 3, y);
        robot.delay(HOLD_MS);
        robot.mouseMove(x, y);
        robot.delay(HOLD_MS);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.delay(HOLD_MS);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    private void picture(String[] words) throws Exception {
        var size = Toolkit.getDefaultToolkit().getScreenSize();
        var area = new Rectangle(Math.min(640, size.width), Math.min(360, size.height));
        ImageIO.write(robot.createScreenCapture(area), "png", new File(words[1]));
    }
}
