package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.View;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import org.junit.jupiter.api.Test;

/** The sphere of the observer's sample follows the player's body and meets the boulder before the camera. */
class ObserverReplayTest {
    private static final double ASPECT = 1.5;

    private final OpenedLevel opened = new LevelName("levels/samples/billboards-observer.json").open();
    private final SimLevel world = SimLevel.of(opened.placed());

    /** Holds one input, which also turns. */
    private record Held(PlayerInput input) implements TickInput {
        @Override
        public PlayerInput next() {
            return input;
        }

        @Override
        public boolean isFinished() {
            return false;
        }
    }

    private Playthrough walk(TickInput input) {
        var beginning = new Playthrough.Beginning("billboards-observer.json", SimSettings.DEFAULT, null);
        var walk = new Playthrough(opened.level(), world, beginning, input);
        walk.observe(ObserverView.of(opened.level(), opened.placed().statics().models()));
        return walk;
    }

    private static List<ObserverSphere> spheres(Playthrough walk, int ticks) {
        List<ObserverSphere> seen = new ArrayList<>();
        for (int i = 0; i < ticks; i++) {
            walk.tick();
            seen.add(walk.frameState().observer());
        }
        return seen;
    }

    @Test
    void aRecordingRepeatsTheSphereAndItsContacts() {
        Playthrough walk = walk(new Held(PlayerInput.FORWARD.turning(500, 0)).unturned());
        List<ObserverSphere> seen = spheres(walk, 240);
        Replay replay = walk.recorder().replay();
        Playthrough again = walk(new ReplayInput(replay));
        assertEquals(seen, spheres(again, 240));
        assertEquals(walk.state().hash(), again.state().hash());
        var last = new long[1];
        replay.play(new Simulation(world, replay.settings()), state -> last[0] = state.hash());
        assertEquals(walk.state().hash(), last[0]);
    }

    /** Forwards is away from the camera, in a straight line, until the boulder's bounds are touched. */
    @Test
    void theSphereMovesStraightAndTouchesTheBoulder() {
        Playthrough walk = walk(new Held(PlayerInput.FORWARD.turning(500, 0)).unturned());
        assertEquals(new Vec3(0, 0.5, 4), walk.frameState().observer().centre());
        View view = walk.view(ASPECT);
        assertEquals(opened.level().cameras().get(0).position(), view.eye());
        List<ObserverSphere> seen = spheres(walk, 240);
        assertSame(view, walk.view(ASPECT));
        int first = 0;
        while (!seen.get(first).touches()) {
            first++;
        }
        assertTrue(seen.subList(0, first).stream()
                .allMatch(sphere -> Math.abs(sphere.centre().x()) < 1e-9));
        double z = seen.get(first).centre().z();
        assertTrue(z > -3 && z < 1, "tick " + first + ", z " + z);
    }

    /** A finer volume lies within a coarser one, so the sphere touches it later or never. */
    @Test
    void finerBoundsAreTouchedLater() {
        int before = 0;
        for (Bound kind : List.of(Bound.BOX, Bound.ORIENTED_BOX, Bound.TREE, Bound.TRIANGLES)) {
            Playthrough walk = walk(new Held(PlayerInput.FORWARD));
            while (walk.observer().touchable() != kind) {
                walk.changePerson();
            }
            List<ObserverSphere> seen = spheres(walk, 240);
            int first = 0;
            while (first < seen.size() && !seen.get(first).touches()) {
                first++;
            }
            assertTrue(first >= before, kind + " at tick " + first);
            before = first;
        }
        assertTrue(before < 240, "the surface is reached");
    }
}
