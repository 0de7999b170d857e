package nephele.host.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Nobody waits longer than a second without a line. */
class LongWorkTest {
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private long nanoseconds = 7_000_000_000L;
    private final LongWork work = new LongWork(printed, "nephele bake", () -> nanoseconds);

    private void pass(double seconds) {
        for (int i = 0; i < 10 * seconds; i++) {
            nanoseconds += 100_000_000L;
            work.look();
        }
    }

    private List<String> lines() {
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    void shortWorkIsSilent() {
        pass(0.9);
        work.done();
        pass(100);
        assertEquals(List.of(), lines());
        assertFalse(work.look());
    }

    @Test
    void longWorkSpeaksAfterASecondAndThenEveryTen() {
        pass(22);
        assertEquals(
                List.of(
                        "nephele bake: at work for 1 s …",
                        "nephele bake: at work for 11 s …",
                        "nephele bake: at work for 21 s …"),
                lines());
    }

    @Test
    void progressOfAPartCountsAsALine() {
        pass(0.5);
        work.err().println("baking: 10 %");
        pass(9);
        work.err().println("baking: 20 %");
        pass(9);
        assertEquals(List.of("baking: 10 %", "baking: 20 %"), lines());
    }
}
