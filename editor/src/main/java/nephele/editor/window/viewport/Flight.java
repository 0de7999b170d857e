package nephele.editor.window.viewport;

import java.awt.event.KeyEvent;
import java.util.HashSet;
import java.util.Set;
import java.util.function.BiConsumer;
import javax.swing.Timer;
import nephele.engine.math.Vec3;

/** Flight of the camera by W, A, S, D, E and Q, by their places on the keyboard, while the right button is held. */
final class Flight {
    private static final Set<Integer> KEYS = Set.of(
            KeyEvent.VK_W,
            KeyEvent.VK_A,
            KeyEvent.VK_S,
            KeyEvent.VK_D,
            KeyEvent.VK_E,
            KeyEvent.VK_Q,
            KeyEvent.VK_SHIFT);
    private static final double START_METRES_PER_SECOND = 6;
    private static final double SPEED_PER_NOTCH = 1.25;
    private static final int TICK_MILLIS = 15;
    private static final double LONGEST_TICK_SECONDS = 0.1;

    private final Set<Integer> held = new HashSet<>();
    private final Timer timer;
    private double metresPerSecond = START_METRES_PER_SECOND;
    private long lastNanos;
    private boolean isOn;

    /** @param move receives the keys held to the right, up and forward, and the distance that full speed covers since the last call, in metres */
    Flight(BiConsumer<Vec3, Double> move) {
        timer = new Timer(TICK_MILLIS, tick -> {
            long now = System.nanoTime();
            double seconds = Math.min(LONGEST_TICK_SECONDS, (now - lastNanos) * 1e-9);
            lastNanos = now;
            double factor = held.contains(KeyEvent.VK_SHIFT) ? 2 : 1;
            move.accept(keys(), factor * metresPerSecond * seconds);
        });
    }

    void begin() {
        isOn = true;
    }

    void end() {
        isOn = false;
        held.clear();
        timer.stop();
    }

    boolean isOn() {
        return isOn;
    }

    /** Makes the flight faster by notches of the wheel, or slower by negative ones. */
    void faster(double notches) {
        double wanted = metresPerSecond * Math.pow(SPEED_PER_NOTCH, notches);
        metresPerSecond = Math.max(0.1, Math.min(1000, wanted));
    }

    /** Takes a key event; returns false if it is none of the flight. */
    boolean key(KeyEvent event) {
        if (!isOn || !KEYS.contains(event.getKeyCode())) {
            return isOn && event.getID() == KeyEvent.KEY_TYPED;
        }
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            held.add(event.getKeyCode());
        } else {
            held.remove(event.getKeyCode());
        }
        boolean moves = held.stream().anyMatch(code -> code != KeyEvent.VK_SHIFT);
        if (moves && !timer.isRunning()) {
            lastNanos = System.nanoTime();
            timer.start();
        } else if (!moves) {
            timer.stop();
        }
        return true;
    }

    private Vec3 keys() {
        return new Vec3(
                axis(KeyEvent.VK_D, KeyEvent.VK_A),
                axis(KeyEvent.VK_E, KeyEvent.VK_Q),
                axis(KeyEvent.VK_W, KeyEvent.VK_S));
    }

    private int axis(int forward, int back) {
        return (held.contains(forward) ? 1 : 0) - (held.contains(back) ? 1 : 0);
    }
}
