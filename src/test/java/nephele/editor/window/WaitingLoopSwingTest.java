package nephele.editor.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.EventQueue;
import java.awt.SecondaryLoop;
import java.awt.Toolkit;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import javax.swing.JLabel;
import nephele.editor.document.BackgroundReading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Swing's thread while it waits for a file. */
@Execution(ExecutionMode.SAME_THREAD)
class WaitingLoopSwingTest {
    private final List<String> events = Collections.synchronizedList(new ArrayList<>());
    private final JLabel label = new JLabel();
    private final BackgroundReading background = new BackgroundReading();

    WaitingLoopSwingTest() {
        background.runOn(new WaitingLoop(() -> {}));
        label.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                events.add("press " + event.getX());
            }
        });
    }

    private void press(int x) {
        Toolkit.getDefaultToolkit()
                .getSystemEventQueue()
                .postEvent(new MouseEvent(label, MouseEvent.MOUSE_PRESSED, 0, 0, x, 0, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void otherEventsAreDispatchedAndTheUsersComeAfterwardsInTheirOrder() throws Exception {
        EventQueue.invokeAndWait(() -> {
            press(1);
            String read = background.get(() -> {
                assertFalse(EventQueue.isDispatchThread());
                press(2);
                CompletableFuture.runAsync(() -> events.add("paint"), EventQueue::invokeLater)
                        .join();
                press(3);
                return "text";
            });
            events.add(read);
        });
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of("paint", "text", "press 1", "press 2", "press 3"), events);
    }

    /** Such a dialogue, of a file that another program has changed, stands above the wait, which cannot end before it. */
    @Test
    void aDialogueThatOpensMeanwhileCanBeAnsweredOnceTheTaskHasEnded() throws Exception {
        var loop = new WaitingLoop(() -> {});
        EventQueue.invokeAndWait(() -> loop.execute(() -> {
            Thread task = Thread.currentThread();
            EventQueue.invokeLater(() -> {
                var dialogue = Toolkit.getDefaultToolkit().getSystemEventQueue().createSecondaryLoop();
                new Thread(() -> answer(task, dialogue)).start();
                dialogue.enter();
                events.add("closed");
            });
        }));
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of("press 1", "closed"), events);
    }

    private void answer(Thread task, SecondaryLoop dialogue) {
        try {
            task.join();
        } catch (InterruptedException interrupted) {
            throw new IllegalStateException(interrupted);
        }
        press(1);
        EventQueue.invokeLater(dialogue::exit);
    }

    @Test
    void aFailureIsThatOfTheReader() throws Exception {
        EventQueue.invokeAndWait(() -> {
            BackgroundReading.Work<String, IOException> broken = () -> {
                throw new IOException("damaged");
            };
            assertEquals(
                    "damaged",
                    assertThrows(IOException.class, () -> background.get(broken))
                            .getMessage());
        });
    }

    @Test
    void aScriptReadsOnItsOwnThread() {
        Thread caller = Thread.currentThread();
        assertEquals(caller, background.get(Thread::currentThread));
    }
}
