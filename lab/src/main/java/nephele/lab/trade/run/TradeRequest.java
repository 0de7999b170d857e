package nephele.lab.trade.run;

import java.nio.file.Path;
import java.util.List;
import nephele.lab.trade.Trade;
import nephele.lab.trade.TradeSite;

/**
 * What was asked for.
 *
 * @param camera one of the level's, {@code null} for the first
 * @param rounds of timing, each of them every setting twice
 * @param sliceSeconds that a setting runs at a time
 */
public record TradeRequest(
        List<Trade> trades,
        String level,
        String camera,
        TradeSite.Extent extent,
        int rounds,
        double sliceSeconds,
        Path folder) {}
