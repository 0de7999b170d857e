package nephele.engine.sim.player;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Lab;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.Tilt;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

final class BodyObstaclesTest {
    private static final Vector3d STILL = new Vector3d();

    /**
     * After a world with bodies, a world without any near an open portal is requested, with more solids than the first.
     * None of its solids is a body.
     */
    @Test
    void whatABodyIsFollowsTheWorldThatWasGivenLast() {
        Lab lab = Lab.hall()
                .cube(new Vec3(0, 0.25, 0), 0.5, 10)
                .pair(new Vec3(-8, 1.05, 0), new Vec3(1, 0, 0), new Vec3(8, 1.05, 0), new Vec3(-1, 0, 0));
        SimLevel level = SimLevel.of(lab.level());
        PortalWorld portalWorld = PortalWorld.of(level.statics(), level.portals());
        var obstacles = new BodyObstacles(level.bodies());
        obstacles.enter(portalWorld, level.bodies().start(), BodyObstacles.NO_BODY);
        var shape = PlayerDimensions.Stance.STANDING.shape(Tilt.UPRIGHT.up());
        CollisionWorld withCube = obstacles.around(0, shape, new Vector3d(0.6, 0.9, 0), STILL);
        assertTrue(obstacles.isBody(withCube.size() - 1));
        assertFalse(obstacles.isBody(withCube.size() - 2));
        CollisionWorld atPortal = obstacles.around(1, shape, new Vector3d(-7.9, 0.9, 0), STILL);
        assertTrue(atPortal.size() > withCube.size());
        for (int i = 0; i < atPortal.size(); i++) {
            assertFalse(obstacles.isBody(i));
        }
        assertTrue(obstacles.isBody(
                obstacles.around(0, shape, new Vector3d(0.6, 0.9, 0), STILL).size() - 1));
    }
}
