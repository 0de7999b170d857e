package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.sim.state.GunPortals.Colour;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import org.junit.jupiter.api.Test;

class EventTextTest {
    @Test
    void everyRefusalHasItsOwnReason() {
        for (Language language : Language.values()) {
            Set<String> texts = new HashSet<>();
            for (Refusal reason : Refusal.values()) {
                texts.add(Message.ofEvent(new TickEvent.PortalRefused(Colour.FIRST, reason, Vec3.ZERO), language)
                        .orElseThrow());
            }
            assertEquals(Refusal.values().length, texts.size());
            assertTrue(texts.stream().allMatch(text -> text.contains(" portal: ")));
        }
    }

    @Test
    void unevenGroundSaysByHowMuch() {
        var refused = new TickEvent.PortalRefused(Colour.FIRST, Refusal.NOT_FLAT, Vec3.ZERO, 0.01001);
        assertEquals(
                "No portal: the ground is uneven by 11 mm here, allowed are 10",
                Message.ofEvent(refused, Language.EN).orElseThrow());
    }

    @Test
    void whatWentWellNeedsNoWords() {
        assertEquals(Optional.empty(), Message.ofEvent(new TickEvent.PortalOpened(Colour.SECOND, 1), Language.EN));
        assertEquals(Optional.empty(), Message.ofEvent(new Handled(Handled.Kind.PICKED_UP, 0), Language.EN));
        assertTrue(Message.ofEvent(new Handled(Handled.Kind.TOO_HEAVY, 0), Language.EN)
                .isPresent());
    }
}
