package nephele.engine.sim.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Lab;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.engine.sim.state.TickEvent.Handled.Kind;
import nephele.engine.sim.state.WorldState.HeldBody;
import org.junit.jupiter.api.Test;

/** Carrying without portals: reach, weight, steadiness, dropping, throwing. */
final class CarryRulesTest {
    private static final double HALF = 0.25;

    /** A cube of 50 cm on the floor 2 m ahead; the player looks down at it. */
    private static Lab atCube(double kilograms) {
        return Lab.hall()
                .cube(new Vec3(0, HALF + 0.001, -2), 2 * HALF, kilograms)
                .startAt(0, 0, 0, 0, -35)
                .hold(PlayerInput.NONE, 0.2);
    }

    @Test
    void whatIsInReachIsHeldBeforeTheEye() {
        Lab lab = atCube(20).press(Action.CARRY);
        assertEquals(0, lab.holding().body());
        assertEquals(List.of(new Handled(Kind.PICKED_UP, 0)), lab.events());
        lab.turn(0, 35).hold(PlayerInput.NONE, 1);
        Vec3 held = lab.body(0);
        assertEquals(0, held.x(), 1e-6);
        assertEquals(1.65, held.y(), 0.01);
        assertEquals(-(0.3 + 0.35 + HALF * Math.sqrt(3)), held.z(), 0.01);
        lab.turn(90, 0).hold(PlayerInput.NONE, 1.5);
        assertEquals(-(0.3 + 0.35 + HALF * Math.sqrt(3)), lab.body(0).x(), 0.01);
        assertEquals(
                0, lab.state().world().bodies().state(0).velocity().toVector().length(), 0.01);
    }

    @Test
    void lettingGoDrops() {
        Lab lab = atCube(20).press(Action.CARRY).turn(0, 35).hold(PlayerInput.NONE, 1);
        lab.press(Action.CARRY).hold(PlayerInput.NONE, 1.5);
        assertFalse(lab.holding().isHolding());
        assertEquals(HALF, lab.body(0).y(), 0.005);
        assertEquals(new Handled(Kind.DROPPED, 0), lab.events().get(1));
    }

    @Test
    void throwingGivesItsSpeedAlongTheView() {
        for (Action trigger : List.of(Action.THROW, Action.FIRE_FIRST)) {
            Lab lab = atCube(20).press(Action.CARRY).turn(0, 35).hold(PlayerInput.NONE, 1);
            Vec3 before = lab.body(0);
            lab.tick(PlayerInput.NONE.holding(trigger));
            assertEquals(new Handled(Kind.THROWN, 0), lab.events().get(1));
            Vec3 speed = lab.state().world().bodies().state(0).velocity();
            assertEquals(-8, speed.z(), 1e-9);
            assertEquals(-9.81 / 120, speed.y(), 1e-9);
            assertEquals(before.z() - 8 / 120.0, lab.body(0).z(), 1e-9);
        }
    }

    @Test
    void handsReachNoFartherAndLiftNoMore() {
        Lab heavy = atCube(51).press(Action.CARRY);
        assertFalse(heavy.holding().isHolding());
        assertEquals(List.of(new Handled(Kind.TOO_HEAVY, 0)), heavy.events());
        Lab far = Lab.hall().cube(new Vec3(0, 1.65, -2.8), 0.5, 1).press(Action.CARRY);
        assertEquals(List.of(TickEvent.Plain.NOTHING_IN_REACH), far.events());
        Lab near = Lab.hall().cube(new Vec3(0, 1.65, -2.7), 0.5, 1).press(Action.CARRY);
        assertTrue(near.holding().isHolding());
        Lab behindPane = Lab.hall()
                .cube(new Vec3(0, 1.65, -2), 0.5, 1)
                .box(-1, 0, -1.1, 1, 3, -1)
                .press(Action.CARRY);
        assertFalse(behindPane.holding().isHolding());
    }

    /** Only a new press counts: a key held down neither drops nor picks up again. */
    @Test
    void aKeyThatStaysDownActsOnce() {
        Lab lab = atCube(20).hold(PlayerInput.NONE.holding(Action.CARRY), 0.5);
        assertEquals(1, lab.events().size());
        assertTrue(lab.holding().isHolding());
    }

    /** The body is dropped after its line of sight is broken for longer than the grace time, and not before. */
    @Test
    void whatIsOutOfSightIsLostAfterTheGrace() {
        Lab lab = Lab.hall()
                .cube(new Vec3(0, 1.65, -1.5), 0.4, 20)
                .box(1, 0, -8, 1.2, 6, 8)
                .press(Action.CARRY)
                .hold(PlayerInput.NONE, 0.5);
        int graceTicks = (int) (CarryRules.GRACE_SECONDS * 120);
        PlayerState here = lab.player();
        PlayerState behindWall = here.withFeet(new Vec3(2, here.feet().y(), 0));
        lab.set(lab.state().withPlayer(behindWall)).hold(PlayerInput.NONE, CarryRules.GRACE_SECONDS);
        assertEquals(graceTicks, lab.holding().ticksUnseen());
        lab.set(lab.state().withPlayer(here)).tick(PlayerInput.NONE);
        assertEquals(0, lab.holding().ticksUnseen());
        assertTrue(lab.holding().isHolding());
        lab.set(lab.state().withPlayer(behindWall)).hold(PlayerInput.NONE, CarryRules.GRACE_SECONDS);
        assertEquals(1, lab.events().size());
        lab.tick(PlayerInput.NONE);
        assertEquals(new Handled(Kind.LOST, 0), lab.events().get(1));
        assertFalse(lab.holding().isHolding());
        assertTrue(lab.body(0).x() <= 0.801, "the wall holds: " + lab.body(0));
    }

    /** A body dropped within the player falls through it, and collides with it again once it is outside. */
    @Test
    void whatIsLetGoWithinThePlayerLeavesCalmly() {
        Lab lab = atCube(20).press(Action.CARRY).hold(PlayerInput.NONE, 0.3);
        lab.turn(0, -50).hold(PlayerInput.NONE, 1);
        Vec3 feet = lab.player().feet();
        lab.press(Action.CARRY);
        assertEquals(0, lab.holding().leaving());
        lab.hold(PlayerInput.NONE, 0.5, state -> {
            assertEquals(feet, state.player().feet());
            Vec3 speed = state.world().bodies().state(0).velocity();
            assertTrue(speed.toVector().length() < 6, speed.toString());
        });
        lab.hold(PlayerInput.NONE.walking(-100, 0), 1);
        assertEquals(HeldBody.NOTHING, lab.holding());
        lab.turn(0, 40).hold(PlayerInput.FORWARD.holding(Action.CROUCH), 0.4);
        assertTrue(lab.player().feet().z() - lab.body(0).z() > 0.5, "solid again");
    }

    /** The held body does not bear the player's weight, and does not obstruct the player. */
    @Test
    void holderAndHeldDoNotPush() {
        Lab lab = atCube(45).press(Action.CARRY).hold(PlayerInput.NONE, 0.5);
        lab.turn(0, -50).hold(PlayerInput.NONE, 1);
        Lab free = Lab.hall().startAt(0, 0, 0, 0, -35).hold(PlayerInput.NONE, 0.2);
        free.tick(PlayerInput.NONE).tick(PlayerInput.NONE).hold(PlayerInput.NONE, 0.5);
        free.turn(0, -50).hold(PlayerInput.NONE, 1);
        assertEquals(free.player(), lab.player());
        lab.hold(PlayerInput.FORWARD, 1);
        free.hold(PlayerInput.FORWARD, 1);
        assertEquals(free.player(), lab.player());
    }
}
