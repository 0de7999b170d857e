package nephele.app.play;

import java.util.List;
import java.util.Optional;
import nephele.engine.sim.state.TickEvent;
import nephele.host.playthrough.Playthrough;

/** Counts what a player did in a run and tells when it has ended. */
final class RunCounter {
    private static final double TICKS_PER_SECOND = 120;

    private int portals;

    void restart() {
        portals = 0;
    }

    /** Returns the finished run if these events end it. */
    Optional<FinishedRun> after(List<TickEvent> events, Playthrough playthrough) {
        if (events.isEmpty()) {
            return Optional.empty();
        }
        for (TickEvent event : events) {
            if (event instanceof TickEvent.PortalOpened) {
                portals++;
            } else if (event instanceof TickEvent.ExitReached) {
                long tick = playthrough.state().world().exit().tick();
                double seconds = tick * playthrough.secondsPerTick();
                return Optional.of(new FinishedRun(
                        Math.round(seconds * TICKS_PER_SECOND),
                        portals,
                        playthrough.hints().given()));
            }
        }
        return Optional.empty();
    }
}
