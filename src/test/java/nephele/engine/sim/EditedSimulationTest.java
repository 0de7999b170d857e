package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState.HeldBody;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * An edit removes the surface under a portal or makes it unportalable: the portal closes, and its occupants are treated
 * as when it is moved. The centre decides their side, or the edit is refused.
 */
final class EditedSimulationTest {
    private static final double EDGE = 0.5;
    /** The index of the solid of {@link Lab#hall} with its face at z = −8. */
    private static final int WALL_AHEAD = 4;

    private static final double WALL = -8;

    /** The edit of the wall under the first portal. */
    private enum Edit {
        NOT_PORTALABLE,
        GONE;

        void of(List<Solid> solids) {
            Solid.Box wall = (Solid.Box) solids.get(WALL_AHEAD);
            solids.set(
                    WALL_AHEAD, new Solid.Box(wall.id(), null, false, null, wall.centre(), wall.size(), wall.faces()));
            if (this == GONE) {
                solids.remove(WALL_AHEAD);
            }
        }
    }

    private static Lab withCubeAt(Lab lab, double beforeTheWall) {
        Bodies bodies = lab.state().world().bodies();
        Vec3 still = Vec3.ZERO;
        var centre = new Vec3(0, EDGE / 2, WALL + beforeTheWall);
        var moved = new BodyState(centre, new Quaterniond(), still, still);
        return lab.set(lab.state().with(lab.state().world().with(bodies.with(0, moved))))
                .hold(PlayerInput.NONE, 0.3);
    }

    private static Simulation edited(Level level, List<Solid> solids) {
        var changed = level.with(level.materials(), solids);
        return new Simulation(changed, SimSettings.DEFAULT);
    }

    private static Simulation edited(Lab lab, Edit edit) {
        List<Solid> solids = new ArrayList<>(lab.level().solids());
        edit.of(solids);
        return edited(lab.level(), solids);
    }

    private static SimState after(Simulation simulation, SimState state, int ticks) {
        SimState now = state;
        for (int i = 0; i < ticks; i++) {
            now = simulation.step(now, PlayerInput.NONE);
        }
        return now;
    }

    @ParameterizedTest
    @EnumSource
    void thePortalClosesAndTheOtherStaysWithoutAPartner(Edit edit) {
        Lab lab = Lab.twoPortals(EDGE);
        Simulation edited = edited(lab, edit);
        SimState state = lab.simulation().continuedIn(edited, lab.state());
        Portals portals = state.world().portals();
        assertEquals(1, portals.size());
        assertFalse(portals.isOpen(0));
        assertEquals(new GunPortals(GunPortals.UNFIRED, 0), state.world().shots());
        assertEquals(lab.state().world().portals().portal(1), portals.portal(0));
        assertEquals(lab.player(), state.player());
        // The gun still works: the first portal is placed in the wall to the left, and both are open.
        SimState again = edited.step(state, PlayerInput.NONE.turning(80_000, 0).holding(Action.FIRE_FIRST));
        again = after(edited, again, 1);
        again = edited.step(again, PlayerInput.NONE.turning(80_000, 0).holding(Action.FIRE_FIRST));
        assertTrue(again.world().portals().isOpen(0) && again.world().portals().isOpen(1));
    }

    /** The cube reaches beyond the plane; it is pushed to the skin's distance before the wall. */
    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.1, 0.2})
    void aCubeInItIsPutOnItsCentresSide(double before) {
        Lab lab = withCubeAt(Lab.twoPortals(EDGE), before);
        assertEquals(WALL + before, lab.body(0).z(), 1e-3);
        Simulation edited = edited(lab, Edit.NOT_PORTALABLE);
        SimState state = lab.simulation().continuedIn(edited, lab.state());
        double at = state.world().bodies().state(0).centre().z();
        assertEquals(WALL + EDGE / 2, at, 2e-3);
        assertTrue(at - EDGE / 2 > WALL - 1e-9, "in the wall by " + (WALL + EDGE / 2 - at));
        Vec3 rested = after(edited, state, 120).world().bodies().state(0).centre();
        assertEquals(0, rested.toVector().distance(0, EDGE / 2, WALL + EDGE / 2), 3e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.15, 0.29})
    void aPlayerInItIsPutOnItsCentresSide(double before) {
        Lab lab = Lab.twoPortals(EDGE);
        lab.set(lab.state().withPlayer(lab.player().withFeet(new Vec3(0, 0, WALL + before))));
        SimState state = lab.simulation().continuedIn(edited(lab, Edit.NOT_PORTALABLE), lab.state());
        assertEquals(WALL + 0.3, state.player().feet().z(), 2e-3);
        assertTrue(state.player().feet().z() >= WALL + 0.3);
    }

    /** If a solid in front of the cube leaves it no room, the edit is refused. */
    @Test
    void withoutRoomTheEditIsRefused() {
        Lab lab = withCubeAt(Lab.twoPortals(EDGE), 0.05);
        List<Solid> solids = new ArrayList<>(lab.level().solids());
        Edit.NOT_PORTALABLE.of(solids);
        double front = WALL + 0.05 + EDGE / 2 + 0.005;
        var block = (Solid.Box)
                Lab.hall().box(-2, 0, front, 2, 2, front + 1).level().solids().get(6);
        solids.add(block);
        assertNull(lab.simulation().continuedIn(edited(lab.level(), solids), lab.state()));
        solids.remove(block);
        assertNotNull(lab.simulation().continuedIn(edited(lab.level(), solids), lab.state()));
    }

    /** A portal closes if a new solid covers only the edge of its aperture; one beside the aperture leaves it open. */
    @Test
    void whatOnlyPartlyHoldsCloses() {
        Lab lab = Lab.twoPortals(EDGE);
        List<Solid> cut = new ArrayList<>(lab.level().solids());
        cut.add(((Solid.Box) Lab.hall()
                .box(0.5, 0, WALL, 3, 2, WALL + 0.005, false)
                .level()
                .solids()
                .get(6)));
        SimState state = lab.simulation().continuedIn(edited(lab.level(), cut), lab.state());
        assertEquals(GunPortals.UNFIRED, state.world().shots().first());
        List<Solid> beside = new ArrayList<>(lab.level().solids());
        beside.add(((Solid.Box) Lab.hall()
                .box(0.7, 0, WALL, 3, 2, WALL + 0.005, false)
                .level()
                .solids()
                .get(6)));
        state = lab.simulation().continuedIn(edited(lab.level(), beside), lab.state());
        assertTrue(state.world().portals().isOpen(0) && state.world().portals().isOpen(1));
    }

    /**
     * A body held along a line through the portal is dropped when the portal closes, and kept if the edit is elsewhere.
     */
    @Test
    void theLineToWhatIsHeldGoesWithThePortal() {
        Lab lab = Lab.twoPortals(EDGE);
        var holding =
                new HeldBody(0, CrossingWord.EMPTY.then(0, lab.state().world().portals()), 0);
        SimState held = lab.state().with(lab.state().world().with(holding));
        Simulation same = edited(lab.level(), lab.level().solids());
        assertEquals(holding, lab.simulation().continuedIn(same, held).world().holding());
        SimState lost = lab.simulation().continuedIn(edited(lab, Edit.GONE), held);
        assertEquals(HeldBody.NOTHING, lost.world().holding());
    }

    /** An edit that changes nothing leaves every bit of the later states as without it. */
    @Test
    void theSameLevelGoesOnBitByBit() {
        Lab lab = Lab.hall()
                .gun()
                .startAt(0, 0, 0, 0, -5)
                .press(Action.FIRE_FIRST)
                .turn(90, 0)
                .press(Action.FIRE_SECOND)
                .hold(PlayerInput.FORWARD, 1);
        Simulation same = edited(lab.level(), lab.level().solids());
        SimState state = lab.simulation().continuedIn(same, lab.state());
        assertEquals(lab.state().hash(), state.hash());
        for (int i = 0; i < 240; i++) {
            state = same.step(state, PlayerInput.FORWARD);
        }
        assertEquals(lab.hold(PlayerInput.FORWARD, 2).state().hash(), state.hash());
    }

    @Test
    void otherBodiesAreAnotherGame() {
        Lab lab = Lab.twoPortals(EDGE);
        Simulation other = new Simulation(Lab.hall().gun().level(), SimSettings.DEFAULT);
        assertThrows(IllegalArgumentException.class, () -> lab.simulation().continuedIn(other, lab.state()));
    }
}
