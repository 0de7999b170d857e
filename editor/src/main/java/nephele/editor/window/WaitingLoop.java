package nephele.editor.window;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.SecondaryLoop;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import javax.swing.Timer;

/**
 * Runs a task on another thread and returns when it has ended. Called on Swing's thread it dispatches events meanwhile, so
 * that windows are painted; the user's input comes after the task, in its order.
 */
public final class WaitingLoop implements Executor {
    private static final int LONG_MILLIS = 500;

    private final Runnable whenLong;

    /** @param whenLong called on Swing's thread if a task takes longer than half a second */
    public WaitingLoop(Runnable whenLong) {
        this.whenLong = whenLong;
    }

    @Override
    public void execute(Runnable task) {
        if (!EventQueue.isDispatchThread()) {
            task.run();
            return;
        }
        var patient = new PatientQueue();
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(patient);
        SecondaryLoop loop = patient.createSecondaryLoop();
        Timer reported = new Timer(LONG_MILLIS, tick -> whenLong.run());
        reported.setRepeats(false);
        reported.start();
        Thread thread = new Thread(
                () -> {
                    try {
                        task.run();
                    } finally {
                        // An event, because the loop cannot be left before it is entered.
                        EventQueue.invokeLater(() -> {
                            patient.isOver = true;
                            loop.exit();
                        });
                    }
                },
                "aside");
        thread.setDaemon(true);
        thread.start();
        loop.enter();
        reported.stop();
        patient.end();
    }

    /** Keeps the user's events until the task is over: then a dialogue that has opened meanwhile can be answered. */
    private static final class PatientQueue extends EventQueue {
        private final List<AWTEvent> kept = new ArrayList<>();
        private boolean isOver;

        @Override
        protected void dispatchEvent(AWTEvent event) {
            boolean isOfUser = event instanceof InputEvent || event.getID() == WindowEvent.WINDOW_CLOSING;
            if (isOfUser && !isOver) {
                kept.add(event);
            } else {
                super.dispatchEvent(event);
            }
        }

        void end() {
            try {
                while (peekEvent() != null) {
                    kept.add(getNextEvent());
                }
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
            }
            pop();
            EventQueue before = Toolkit.getDefaultToolkit().getSystemEventQueue();
            kept.forEach(before::postEvent);
        }
    }
}
