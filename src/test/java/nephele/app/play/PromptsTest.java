package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import nephele.app.settings.GameSettings;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.host.playthrough.CrosshairState;
import nephele.host.playthrough.CrosshairState.Half;
import nephele.host.playthrough.CrosshairState.Shot;
import nephele.host.playthrough.Playthrough;
import nephele.host.playthrough.ReplayInput;
import nephele.host.playthrough.TickInput;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A possible action is named with its key until it has been done. */
class PromptsTest {
    private static final List<String> MOTIONS = List.of("look", "walk", "run", "jump", "goal");

    private final PlayerFiles files = new PlayerFiles(new UserFolders(null, null, null));
    private final Prompts prompts = afterMotions();
    private GameSettings settings = GameSettings.DEFAULT;
    private Input.Device device = Input.Device.KEYBOARD;

    /** Returns the prompts of a player who moves already. */
    private Prompts afterMotions() {
        MOTIONS.forEach(motion -> files.keep(files.progress().withLearned(motion)));
        return new Prompts(files);
    }

    private static Playthrough playing(PlayerInput... inputs) {
        Level level = new TestLevel()
                .box(null, new Vec3(0, -0.5, 0), new Vec3(20, 1, 20))
                .level();
        var ticks = List.of(inputs).iterator();
        TickInput input = new TickInput() {
            @Override
            public PlayerInput next() {
                return ticks.hasNext() ? ticks.next() : PlayerInput.NONE;
            }

            @Override
            public boolean isFinished() {
                return false;
            }
        };
        return new Playthrough(level, new Playthrough.Beginning("a.json", SimSettings.DEFAULT, null), input);
    }

    /** Plays a number of ticks, a prompt each. Returns the last one. */
    private String after(Prompts named, Playthrough walk, int ticks) {
        String last = null;
        for (int i = 0; i < ticks; i++) {
            walk.tick();
            last = named.text(walk, new CrosshairState(0, 0, null, null), settings, device);
        }
        return last;
    }

    private static PlayerInput[] times(int ticks, PlayerInput input) {
        return Collections.nCopies(ticks, input).toArray(new PlayerInput[0]);
    }

    @Test
    void lookingAndWalkingAreNamedUntilDoneAndNeverAgain(@TempDir Path folder) {
        var folders = new UserFolders(folder, folder, folder);
        var fresh = new Prompts(new PlayerFiles(folders));
        assertEquals("Mouse: look around", after(fresh, playing(), 2));
        assertEquals("W A S D: walk", after(fresh, playing(times(30, PlayerInput.NONE.turning(1000, 0))), 40));
        device = Input.Device.GAMEPAD;
        assertEquals("L: walk", after(fresh, playing(), 1));
        device = Input.Device.KEYBOARD;
        settings = settings.with(Settings.KEYS.get(Control.FORWARD), List.of("Z"));
        assertEquals("Z A S D: walk", after(fresh, playing(), 1));
        assertNull(after(fresh, playing(times(120, PlayerInput.NONE.walking(100, 0))), 120));
        assertNull(after(new Prompts(new PlayerFiles(folders)), playing(), 2), "kept in the file of progress");
    }

    @Test
    void whatALevelMayNotNeedIsNamedForSomeSecondsOneAfterTheOther() {
        var fresh = new PlayerFiles(new UserFolders(null, null, null));
        List.of("look", "walk").forEach(word -> fresh.keep(fresh.progress().withLearned(word)));
        var named = new Prompts(fresh);
        Playthrough walk = playing();
        assertNull(after(named, walk, 2 * 120), "a rest at first");
        assertEquals("Left Shift: run", after(named, walk, 3 * 120));
        assertNull(after(named, walk, 7 * 120));
        assertEquals("Space: jump", after(named, walk, 3 * 120));
        named.goalShown();
        Playthrough another =
                playing(times(6 * 120, PlayerInput.NONE.walking(100, 0).holding(Action.RUN)));
        assertEquals("Space: jump", after(named, another, 5 * 120), "in the next level those that were not done");
        assertTrue(fresh.progress().hasLearned("run") && fresh.progress().hasLearned("goal"));
        assertFalse(fresh.progress().hasLearned("jump"));
    }

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
        Half half = new Half(false, first, unevenMillimetres);
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
        assertEquals("Left click: open the first portal", text(far, Shot.OPENS));
        prompts.after(List.of(new TickEvent.PortalOpened(GunPortals.Colour.FIRST, 0)));
        assertEquals("Right click: open the second portal", text(far, Shot.OPENS));
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
