package nephele.app.play;

import java.util.Optional;
import nephele.engine.portal.placement.Refusal;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;

/** The message for an event of a tick: only events that prevented an action have one. */
final class EventText {
    private EventText() {}

    static Optional<String> of(TickEvent event) {
        if (event instanceof TickEvent.PortalRefused refused) {
            return Optional.of("No portal: " + reason(refused.reason()));
        }
        if (event instanceof Handled handled) {
            return switch (handled.kind()) {
                case TOO_HEAVY -> Optional.of("Too heavy");
                case LOST -> Optional.of("Let go: nothing leads to it any more");
                case PICKED_UP, DROPPED, THROWN -> Optional.empty();
            };
        }
        return Optional.empty();
    }

    private static String reason(Refusal reason) {
        return switch (reason) {
            case NOTHING_HIT -> "nothing is there";
            case OUT_OF_RANGE -> "too far away";
            case MOVING_SURFACE -> "something that moves is in the way";
            case NOT_PORTALABLE -> "this surface takes none";
            case OVERLAPS_OTHER -> "the other portal is in its place";
            case TOO_SMALL -> "the surface is too small";
            case EDGE -> "too near the edge";
            case OCCUPIED -> "something stands in the old one and has no room";
        };
    }
}
