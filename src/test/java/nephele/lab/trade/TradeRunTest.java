package nephele.lab.trade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Runs of invented subjects without pictures save, resume and report their measurements. */
@Execution(ExecutionMode.CONCURRENT)
class TradeRunTest {
    private static final int ROUNDS = 4;
    private static final BooleanSupplier NEVER = () -> false;

    @TempDir
    Path folder;

    private final ByteArrayOutputStream told = new ByteArrayOutputStream();

    /** An experiment with errors that depend on the setting's index; it throws in the middle if told to. */
    private static final class Counting implements Experiment {
        private final BooleanSupplier dies;
        int judged;
        int runs;
        boolean closed;

        Counting(BooleanSupplier dies) {
            this.dies = dies;
        }

        @Override
        public Judgement judge(int setting) {
            judged++;
            return Judgement.of(3.0 - setting, 10.0 * setting);
        }

        @Override
        public void run(int setting) {
            runs++;
            if (dies.getAsBoolean()) {
                throw new IllegalStateException("killed");
            }
        }

        @Override
        public void close() {
            closed = true;
        }
    }

    @Test
    void whatWasKilledGoesOnWhereItWas() throws IOException {
        var killed = new Counting(() -> told().contains("timed 2 of"));
        assertThrows(IllegalStateException.class, () -> run(killed, "levels/samples/empty.json", ROUNDS));
        assertTrue(killed.closed);
        assertEquals(3, killed.judged);
        int roundsBefore = 2;

        var next = new Counting(NEVER);
        var found = run(next, "levels/samples/empty.json", roundsBefore + 1);
        assertEquals(0, next.judged, "judgements are kept");
        assertEquals(1, told().lines().filter(line -> line.contains("timed")).count(), "rounds are kept");
        assertEquals(roundsBefore + 1, found.rounds());
        assertEquals(3, found.settings().get(0).error());
        assertEquals(List.of(20.0), found.settings().get(2).figures());

        var third = new Counting(() -> true);
        run(third, "levels/samples/empty.json", roundsBefore + 1);
        assertTrue(told().contains("was measured before"), told());
    }

    @Test
    void whatWasMeasuredElsewhereDoesNotCount() throws IOException {
        run(new Counting(NEVER), "levels/samples/empty.json", ROUNDS);
        var elsewhere = new Counting(NEVER);
        run(elsewhere, "levels/samples/solid-box.json", ROUNDS);
        assertEquals(3, elsewhere.judged);
        assertTrue(told().contains("measured again"), told());
    }

    @Test
    void aDamagedFileCountsAsNone() throws IOException {
        run(new Counting(NEVER), "levels/samples/empty.json", ROUNDS);
        Path kept = folder.resolve("partial/counting.properties");
        String whole = Files.readString(kept);
        for (String damaged :
                new String[] {"", "\\u00", whole.replace("judged.1=number ", "judged.1="), whole.replace("E", "Q")}) {
            Files.writeString(kept, damaged);
            var again = new Counting(NEVER);
            assertEquals(
                    3,
                    run(again, "levels/samples/empty.json", ROUNDS).settings().size());
        }
    }

    private Findings run(Counting experiment, String level, int rounds) throws IOException {
        told.reset();
        var request = new TradeRequest(
                List.of(trade(experiment)), level, null, new TradeSite.Extent(16, 9, 1), rounds, 1e-4, folder);
        return new TradeRun(request, new PrintStream(told, true, StandardCharsets.UTF_8))
                .measure()
                .get(0);
    }

    private String told() {
        return told.toString(StandardCharsets.UTF_8);
    }

    private static Trade trade(Counting experiment) {
        return new Trade(
                "counting",
                new Trade.Text("Counting", "Counts what is asked of it and nothing else.", "nothing"),
                List.of(),
                List.of(Setting.of("a"), Setting.of("b"), Setting.of("c")),
                1,
                new ErrorMetric("error", "m", 0.1, 1),
                List.of("tens"),
                new CostMetric("CPU", "ns", 1, 1, CostMetric.Clock.THREAD),
                null,
                site -> experiment);
    }
}
