package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.playthrough.CrosshairState;
import nephele.engine.playthrough.CrosshairState.Half;
import nephele.engine.playthrough.CrosshairState.Portal;
import nephele.engine.playthrough.CrosshairState.Shot;
import nephele.engine.playthrough.Playthrough;
import nephele.engine.playthrough.ReplayInput;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import org.junit.jupiter.api.Test;

/** A possible action is named with its key until it has been done. */
class PromptsTest {
    private final Prompts prompts = new Prompts();
    private GameSettings settings = GameSettings.DEFAULT;
    private Input.Device device = Input.Device.KEYBOARD;

    private static Playthrough standing(double cubeZ) {
        Level level = new TestLevel()
                .box(null, new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                .cube(null, new Vec3(0, 1.5, cubeZ), 0.4)
                .level();
        var input = new ReplayInput(Replay.standing("a.json", 1));
        return new Playthrough(level, new Playthrough.Beginning("a.json", SimSettings.DEFAULT, null), input);
    }

    private String text(Playthrough playthrough, Shot first) {
        return text(playthrough, first, 0);
    }

    private String text(Playthrough playthrough, Shot first, long unevenMillimetres) {
        Half half = new Half(Portal.NONE, first, unevenMillimetres);
        return prompts.text(playthrough, new CrosshairState(0, 0, half, half), settings, device);
    }

    @Test
    void aBodyInReachIsOfferedUntilOneWasPickedUp() {
        Playthrough near = standing(-1.2);
        assertEquals("E: pick up", text(near, Shot.REFUSED));
        device = Input.Device.GAMEPAD;
        assertEquals("X: pick up", text(near, Shot.REFUSED));
        device = Input.Device.KEYBOARD;
        assertNull(text(standing(-8), Shot.REFUSED));
        settings =
                settings.with(Settings.KEYS.get(Control.CARRY), List.of("Q")).with(Settings.LANGUAGE, Language.PT_PT);
        assertEquals("Q: agarrar", text(near, Shot.REFUSED));
        prompts.after(List.of(new Handled(Handled.Kind.PICKED_UP, 0)));
        assertNull(text(near, Shot.REFUSED));
    }

    @Test
    void aShotThatOpensIsOfferedUntilItWasFired() {
        Playthrough far = standing(-8);
        assertEquals("left click: open the first portal", text(far, Shot.OPENS));
        prompts.after(List.of(new TickEvent.PortalOpened(GunPortals.Colour.FIRST, 0)));
        assertEquals("right click: open the second portal", text(far, Shot.OPENS));
        assertNull(text(far, Shot.REFUSED));
        prompts.after(List.of(new TickEvent.PortalOpened(GunPortals.Colour.SECOND, 1)));
        assertNull(text(far, Shot.OPENS));
    }

    @Test
    void unevenGroundSaysWhyNoShotIsOffered() {
        assertEquals(
                "No portal: the ground is uneven by 14 mm here, allowed are 10", text(standing(-8), Shot.REFUSED, 14));
        assertEquals("E: pick up", text(standing(-1.2), Shot.REFUSED, 14));
        settings = settings.with(Settings.LANGUAGE, Language.PT_PT);
        assertEquals(
                "Sem portal: o chão tem 23 mm de desnível aqui, são permitidos 10",
                text(standing(-8), Shot.REFUSED, 23));
        assertNull(text(standing(-8), Shot.REFUSED, 0));
    }
}
