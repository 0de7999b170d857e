package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CountDownLatch;
import nephele.editor.play.PlayOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class OrderQueueTest {
    private static final PlayOrder ORDER = new PlayOrder("a.json", "b.json", null, null, null);

    private static OrderQueue reading(String text) throws InterruptedException {
        var end = new CountDownLatch(1);
        var queue = OrderQueue.reading(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), end::countDown);
        end.await();
        return queue;
    }

    private static PlayOrder ordered(OrderQueue.Entry entry) {
        return assertInstanceOf(OrderQueue.Ordered.class, entry).order();
    }

    @Test
    void ordersComeInTheirOrderAndThenTheEnd() throws Exception {
        var other = new PlayOrder("c.json", "d.json", null, "high", null);
        var queue = reading(ORDER.line() + "\n" + other.line() + "\r\n");
        assertEquals(ORDER, ordered(queue.take()));
        assertEquals(other, ordered(queue.take()));
        assertTrue(queue.isAnyWaiting());
        assertInstanceOf(OrderQueue.Leave.class, queue.take());
    }

    @Test
    void nothingIsReadAfterQuit() throws Exception {
        var queue = reading("quit\n" + ORDER.line() + "\n");
        assertInstanceOf(OrderQueue.Leave.class, queue.take());
        assertTrue(!queue.isAnyWaiting());
    }

    @Test
    void aWrongLineIsToldAndTheNextOneIsRead() throws Exception {
        var queue = reading("x".repeat(3 * PlayOrder.MOST_CHARACTERS) + "\n" + ORDER.line());
        var rejected = assertInstanceOf(OrderQueue.Rejected.class, queue.take());
        assertTrue(rejected.message().contains("longer than"), rejected.message());
        assertEquals(ORDER, ordered(queue.take()));
    }

    @Test
    void ofTooManyOrdersTheLatestStayAndTheEndIsKept() throws Exception {
        var queue = reading((ORDER.line() + "\n").repeat(100));
        int count = 0;
        OrderQueue.Entry entry = queue.take();
        for (; entry instanceof OrderQueue.Ordered; entry = queue.take()) {
            count++;
        }
        assertInstanceOf(OrderQueue.Leave.class, entry);
        assertTrue(count < 10);
    }
}
