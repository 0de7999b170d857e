package nephele.app.play;

import java.util.Optional;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;

/** The message for an event of a tick: only events that prevented an action have one. */
final class EventText {
    private EventText() {}

    static Optional<String> of(TickEvent event, Language language) {
        if (event instanceof TickEvent.PortalRefused refused) {
            long millimetres = PlacementResult.Refused.millimetres(refused.unevenMetres());
            return Optional.of(refusal(refused.reason(), millimetres, language));
        }
        if (event instanceof TickEvent.BodyReturned) {
            return Optional.of(Phrase.RETURNED.in(language));
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

    /** @param unevenMillimetres by how much the ground is uneven, if that is the reason */
    static String refusal(Refusal reason, long unevenMillimetres, Language language) {
        return Phrase.NO_PORTAL.in(language, Phrase.ofRefusal(reason).in(language, unevenMillimetres));
    }
}
