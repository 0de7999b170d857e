package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** `--ticks-per-second`. */
public final class TickRateSubject {
    static final int[] RATES = {30, 60, 120, 240};

    /** Of the player's radius. */
    private static final double TENTH_OF_A_BODY_MM = 30;

    public static final Trade TRADE = new Trade(
            "tickRate",
            new Trade.Text(
                    "Ticks a second",
                    "How often the simulation moves the player. Between ticks the picture is interpolated, so a low"
                        + " rate does not look rough; but landings, corners and stairs come a little early or late,"
                        + " and a walk ends a little elsewhere. Walks of three seconds, a new random wish every half"
                        + " second.",
                    "the same walks at 960 ticks a second, and with the height of a jump, v²/2g"),
            List.of(),
            Stream.of("30", "60", "120", "240")
                    .map(rate -> new Setting(rate, rate.equals("120") ? "the game's" : ""))
                    .toList(),
            2,
            new ErrorMetric("median deviation of a walk", "mm", 0.1, TENTH_OF_A_BODY_MM),
            List.of("deviation of the worst walk, mm", "jump too low by, mm"),
            new CostMetric("CPU a simulated second", "µs", 1e3, ScriptedWalk.SECONDS, CostMetric.Clock.THREAD),
            site -> new TickRateExperiment());

    private TickRateSubject() {}
}
