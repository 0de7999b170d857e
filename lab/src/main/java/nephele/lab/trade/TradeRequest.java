package nephele.lab.trade;

import java.nio.file.Path;
import java.util.List;

/**
 * A request for a report.
 *
 * @param camera id of one of the level's cameras; {@code null} for the one that sees the most portal pixels
 * @param rounds of timing; a round runs every setting twice
 * @param sliceSeconds the least time that a setting runs without interruption
 */
public record TradeRequest(
        List<Trade> trades,
        String level,
        String camera,
        TradeSite.Extent extent,
        int rounds,
        double sliceSeconds,
        Path folder) {}
