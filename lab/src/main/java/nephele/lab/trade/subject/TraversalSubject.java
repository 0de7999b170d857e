package nephele.lab.trade.subject;

import java.util.List;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** How a player gets through a portal: the student report's leap against the time of impact. */
public final class TraversalSubject {
    public static final Trade TRADE = new Trade(
            "traversal",
            new Trade.Text(
                    "Going through a portal",
                    "The source moves whoever is near to the middle before the other portal and makes them look along"
                        + " its normal. The game finds the instant at which the body's centre enters, and turns"
                        + " everything by the portals' rigid map. Leaps are in pixels of a 1280×720 picture, points"
                        + " that leave it counting as its diagonal; cost is that of looking for portals in a tick of"
                        + " walking.",
                    "a window: what is seen does not leap at all"),
            List.of(),
            List.of(
                    new Setting("teleport", "the source's way, within " + SourceTeleport.NEAR_METRES + " m"),
                    new Setting("teleportKeepingView", "the same, but the view keeps its angle to the portal"),
                    new Setting("timeOfImpact", "the game's")),
            2,
            new ErrorMetric("mean leap of picture points", "px", 0.01, 0.5),
            List.of("median turn of the view, °", "worst turn, °", "leap of the eye, m"),
            new CostMetric("CPU a tick", "ns", 1, TraversalExperiment.TICKS_PER_RUN, CostMetric.Clock.THREAD),
            site -> new TraversalExperiment());

    private TraversalSubject() {}
}
