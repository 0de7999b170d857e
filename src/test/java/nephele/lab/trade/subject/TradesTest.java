package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import nephele.engine.render.frame.Quality;
import nephele.host.terminal.CommandFailure;
import nephele.lab.trade.Trade;
import org.junit.jupiter.api.Test;

class TradesTest {
    /** Every field of Quality has a subject, and every subject's fields exist. */
    @Test
    void everyFieldOfQualityHasASubject() {
        Set<String> fields = Arrays.stream(Quality.class.getRecordComponents())
                .map(RecordComponent::getName)
                .collect(Collectors.toSet());
        Set<String> explained = Trades.ALL.stream()
                .flatMap(trade -> trade.qualityFields().stream())
                .collect(Collectors.toSet());
        assertEquals(fields, explained);
    }

    @Test
    void subjectsAreFileNamesOfTheirOwnAndTellWhatTheyAre() {
        assertEquals(
                Trades.ALL.size(),
                Trades.ALL.stream().map(Trade::subject).distinct().count());
        for (Trade trade : Trades.ALL) {
            assertTrue(trade.subject().matches("[A-Za-z]+"), trade.subject());
            assertTrue(trade.settings().size() >= 2, trade.subject());
            assertTrue(trade.text().about().length() > 40, trade.subject());
            assertTrue(trade.figures().size() <= 7, "as many as the table has columns: " + trade.subject());
        }
    }

    @Test
    void namedInAnyOrderTheyKeepTheirs() {
        var named = Trades.named(List.of("tickRate", "shadow"));
        assertEquals(
                List.of("shadow", "tickRate"),
                named.stream().map(Trade::subject).toList());
        assertEquals(Trades.ALL, Trades.named(List.of()));
    }

    @Test
    void anUnknownNameIsToldWithThoseThatExist() {
        var failure = assertThrows(CommandFailure.class, () -> Trades.named(List.of("shadows")));
        assertTrue(failure.getMessage().startsWith("there is no subject `shadows`; there are: "), failure.getMessage());
        assertTrue(failure.getMessage().contains("tickRate"), failure.getMessage());
    }
}
