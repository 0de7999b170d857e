package nephele.app.play;

import java.util.Optional;
import nephele.app.text.Phrase;
import nephele.engine.level.Language;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;

/** The message for an event of a tick: only events that prevented an action have one. */
final class EventText {
    private EventText() {}

    static Optional<String> of(TickEvent event, Language language) {
        if (event instanceof TickEvent.PortalRefused refused) {
            String reason = Phrase.ofRefusal(refused.reason())
                    .in(language, PlacementResult.Refused.millimetres(refused.unevenMetres()));
            return Optional.of(Phrase.NO_PORTAL.in(language, reason));
        }
        if (event instanceof Handled handled) {
            return switch (handled.kind()) {
                case TOO_HEAVY -> Optional.of(Phrase.TOO_HEAVY.in(language));
                case LOST -> Optional.of(Phrase.LOST.in(language));
                case PICKED_UP, DROPPED, THROWN -> Optional.empty();
            };
        }
        return Optional.empty();
    }
}
