package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.sim.carry.PortalOccupants;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimState;
import org.joml.Quaterniond;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A body in a portal that is moved away is pushed to an exactly known place. */
final class PortalOccupantsPushTest {
    private static final double EDGE = 0.5;

    /** The cube is pushed out of the old portal's plane, which is the wall's, to the skin's distance. */
    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.1, 0.2})
    void aCubeEndsTheSkinBeforeTheWall(double before) {
        Lab lab = Lab.twoPortals(EDGE);
        SimState inPortal = withCubeAt(lab.state(), new Vec3(0, EDGE / 2 + 0.002, -8 + before));
        Lab moved = lab.turn(90, 0).press(Action.FIRE_FIRST);
        SimLevel level = SimLevel.of(lab.level());
        PortalWorld from = PortalWorld.of(level.statics(), inPortal.world().portals());
        PortalWorld to = PortalWorld.of(level.statics(), moved.state().world().portals());
        var occupants = new PortalOccupants(level.bodies());

        Vec3 centre =
                occupants.settle(inPortal, from, to).world().bodies().state(0).centre();
        assertEquals(-8 + EDGE / 2 + Sweep.SKIN_METRES, centre.z(), 1e-12);
        assertEquals(0, centre.x(), 1e-12);
        assertEquals(EDGE / 2 + 0.002, centre.y(), 1e-12);

        SimState clear = withCubeAt(inPortal, new Vec3(0, EDGE / 2 + 0.002, -7));
        assertSame(
                clear.world().bodies(),
                occupants.settle(clear, from, to).world().bodies());
    }

    private static SimState withCubeAt(SimState state, Vec3 centre) {
        Bodies bodies = state.world().bodies();
        var there = new BodyState(centre, new Quaterniond(), Vec3.ZERO, Vec3.ZERO);
        return state.with(state.world().with(bodies.with(0, there)));
    }
}
