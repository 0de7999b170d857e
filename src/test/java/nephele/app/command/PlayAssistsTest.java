package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.sim.state.Assist;
import nephele.host.terminal.CommandFailure;
import org.junit.jupiter.api.Test;

final class PlayAssistsTest {
    @Test
    void whoNamesNoneGetsTheDefault() {
        assertEquals(Assist.USUAL, PlayCommand.assists(null));
        assertEquals(List.of(), PlayCommand.assists(List.of("none")));
        assertEquals(List.of(Assist.SPEED_CAP), PlayCommand.assists(List.of("speed-cap")));
    }

    @Test
    void anUnknownNameIsToldWithThoseThereAre() {
        var failure = assertThrows(CommandFailure.class, () -> PlayCommand.assists(List.of("funel")));
        assertTrue(failure.getMessage().contains("funnel, floor-exit-speed, speed-cap, body-return, "));
        assertThrows(CommandFailure.class, () -> PlayCommand.assists(List.of("none", "funnel")));
    }
}
