package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Player and bodies collide with each other, on one side of a portal and through it. */
final class PlayerAndBodiesTest {
    private static Lab cubeAhead(double kilograms) {
        return Lab.hall().cube(new Vec3(0, 0.501, -2), 1, kilograms).hold(PlayerInput.NONE, 0.5);
    }

    @Test
    void whatIsTooHeavyStopsAWalker() {
        Lab lab = cubeAhead(2000).hold(PlayerInput.FORWARD, 2);
        assertEquals(-2, lab.body(0).z(), 1e-3);
        assertEquals(
                -1.5 + PlayerDimensions.RADIUS_METRES + Sweep.SKIN_METRES,
                lab.player().feet().z(),
                2e-3);
    }

    @Test
    void whatIsLightIsPushedAlong() {
        Lab lab = cubeAhead(20).hold(PlayerInput.FORWARD, 1.2);
        // The legs push 80 kg and 20 kg with 400 N against 118 N of friction.
        double acceleration = (400 - 0.6 * 20 * 9.81) / 100;
        assertEquals(acceleration * 0.1, speedGained(lab, 0.1), 0.01);
        lab.hold(PlayerInput.FORWARD, 0.6);
        assertTrue(lab.body(0).z() < -3.5, "pushed only to " + lab.body(0));
        double gap = lab.player().feet().z()
                - PlayerDimensions.RADIUS_METRES
                - (lab.body(0).z() + 0.5);
        assertTrue(gap > 0 && gap < 0.05, "gap " + gap);
        assertTrue(Math.abs(lab.player().velocity().z()) <= PlayerDimensions.WALK_METRES_PER_SECOND + 1e-9);
    }

    private static double speedGained(Lab lab, double seconds) {
        double before = lab.player().velocity().z();
        return before
                - lab.hold(PlayerInput.FORWARD, seconds).player().velocity().z();
    }

    @Test
    void oneStandsAndWalksOnABody() {
        Lab lab = Lab.hall().cube(new Vec3(0, 0.501, 0), 1, 30).startAt(0, 1.3, 0, 0, 0);
        lab.hold(PlayerInput.NONE, 1);
        assertTrue(lab.player().isGrounded());
        assertEquals(1, lab.player().feet().y(), 3e-3);
        assertEquals(0, lab.body(0).x(), 1e-3);
        double height = lab.player().feet().y();
        lab.hold(PlayerInput.NONE, 5);
        assertEquals(height, lab.player().feet().y(), 1e-3);
        assertEquals(0.5, lab.body(0).y(), 3e-3);
        lab.hold(PlayerInput.FORWARD, 1);
        assertEquals(0, lab.player().feet().y(), 2e-3);
        assertEquals(0, lab.body(0).z(), 0.02);
    }

    @Test
    void aPlayerOnOneEndTipsAPlank() {
        var plank =
                new nephele.engine.level.Body.Box("plank", new Vec3(0, 0.45, 0), new Vec3(3, 0.1, 1), 20, null, 0.6, 0);
        Lab lab = Lab.hall().box(-0.1, 0, -0.5, 0.1, 0.4, 0.5).body(plank).startAt(1.2, 0.6, 0, 0, 0);
        lab.hold(PlayerInput.NONE, 1);
        Vec3 right = new Vec3(1, 0, 0);
        double slope = Vec3.of(
                        lab.state().world().bodies().state(0).orientation().transform(right.toVector()))
                .y();
        assertTrue(slope < -0.1, "the plank's slope is " + slope);
    }

    @ParameterizedTest
    @ValueSource(doubles = {5, 80, 400})
    void whatFliesIntoAPlayerGivesItItsMomentum(double kilograms) {
        Lab lab = Lab.hall().cube(new Vec3(0, 1, -3), 0.6, kilograms);
        BodyState thrown = new BodyState(new Vec3(0, 1, -3), new Quaterniond(), new Vec3(0, 1, 8), Vec3.ZERO);
        lab.set(lab.state()
                .with(lab.state().world().with(lab.state().world().bodies().with(0, thrown))));
        double fastest = 0;
        for (int i = 0; i < 60; i++) {
            lab.tick(PlayerInput.NONE);
            fastest = Math.max(fastest, lab.player().velocity().z());
        }
        double together = kilograms * 8 / (kilograms + PlayerDimensions.MASS_KILOGRAMS);
        assertTrue(fastest > 0.6 * together && fastest < 1.1 * together, fastest + " m/s of " + together);
    }

    @Test
    void theJumpOntoABodyIsAsHighAsOntoStone() {
        Lab lab = Lab.hall().cube(new Vec3(0, 0.451, -1.2), 0.9, 100).hold(PlayerInput.NONE, 0.2);
        lab.tick(PlayerInput.FORWARD.holding(Action.JUMP))
                .hold(PlayerInput.FORWARD, 0.35)
                .hold(PlayerInput.NONE, 1);
        assertTrue(lab.player().isGrounded());
        assertEquals(0.9, lab.player().feet().y(), 4e-3);
    }

    @Test
    void aBodyBehindAPortalStopsWhoWalksThrough() {
        Vec3 entry = new Vec3(0, 1.05, -8);
        Vec3 exit = new Vec3(-8, 1.05, 0);
        Lab lab = Lab.hall()
                .pair(entry, new Vec3(0, 0, 1), exit, new Vec3(1, 0, 0))
                .cube(new Vec3(-7.4, 0.501, 0), 1, 3000)
                .startAt(0, 0, -6, 0, 0);
        lab.hold(PlayerInput.FORWARD, 2);
        // The cube's near face is 10 cm before the exit: the capsule's front reaches that far through.
        assertEquals(
                -8 + PlayerDimensions.RADIUS_METRES - 0.1 + Sweep.SKIN_METRES,
                lab.player().feet().z(),
                3e-3);
        assertEquals(-7.4, lab.body(0).x(), 1e-3);
    }

    @Test
    void aBodyInTheNextRoomIsNotMetThroughAPortal() {
        Lab open = Lab.hall()
                .pair(new Vec3(0, 1.05, -8), new Vec3(0, 0, 1), new Vec3(-8, 1.05, 0), new Vec3(1, 0, 0))
                .cube(new Vec3(0, 0.501, -10), 1, 3000)
                .box(-4, -1, -14, 4, 0, -9)
                .startAt(0, 0, -6, 0, 0);
        open.hold(PlayerInput.FORWARD, 1.5);
        assertFalse(
                open.player().feet().z() < -6.5, "not through: " + open.player().feet());
        assertTrue(open.player().feet().x() > -7 && open.player().feet().x() < -1);
    }
}
