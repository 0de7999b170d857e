package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.sim.carry.CarryRules;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.engine.sim.state.TickEvent.Handled.Kind;
import org.junit.jupiter.api.Test;

/** Carrying through portals: player or cube first, several portals, one moved in between. */
final class CarryThroughPortalsTest {
    private static final Vec3 BACK = new Vec3(0, 0, 1);
    private static final Vec3 LEFT = new Vec3(-1, 0, 0);
    private static final Vec3 RIGHT = new Vec3(1, 0, 0);
    /** The distance from the eye to a held cube of 40 cm: radius, gap and half the diagonal. */
    private static final double HELD_METRES = 0.3 + 0.35 + 0.2 * Math.sqrt(3);

    /**
     * Portal 0 in the wall ahead leads to 1 in the wall to the right; 2 in the wall to the left leads to 3 in the one
     * behind.
     */
    private static Lab hall() {
        return Lab.hall()
                .pair(new Vec3(0, 1.05, -8), BACK, new Vec3(8, 1.05, 0), LEFT)
                .pair(new Vec3(-8, 1.05, 0), RIGHT, new Vec3(3, 1.05, 8), new Vec3(0, 0, -1));
    }

    private static Lab holding(Lab lab) {
        Lab held = lab.press(Action.CARRY).hold(PlayerInput.NONE, 0.3);
        assertTrue(held.holding().isHolding(), held.events().toString());
        return held;
    }

    private static List<Integer> letters(CrossingWord word) {
        return IntStream.range(0, word.length()).mapToObj(word::entry).toList();
    }

    private static void assertStillHeld(Lab lab) {
        assertTrue(lab.holding().isHolding(), lab.events().toString());
        assertEquals(List.of(new Handled(Kind.PICKED_UP, 0)), lab.events());
    }

    @Test
    void theBodyGoesFirstAndThePlayerFollows() {
        Lab lab = holding(hall().cube(new Vec3(0, 1.65, -6.3), 0.4, 20).startAt(0, 0, -5, 0, 0));
        lab.hold(PlayerInput.FORWARD, 0.65);
        assertEquals(List.of(0), letters(lab.holding().word()));
        assertTrue(lab.body(0).x() > 7, "beyond: " + lab.body(0));
        // A wait does not move it.
        lab.hold(PlayerInput.NONE, 1);
        Vec3 waiting = lab.body(0);
        lab.hold(PlayerInput.NONE, 1);
        assertEquals(0, waiting.toVector().distance(lab.body(0).toVector()), 1e-6);
        double behindPortal = HELD_METRES - (lab.player().feet().z() + 8);
        assertEquals(8 - behindPortal, lab.body(0).x(), 0.02);
        lab.hold(PlayerInput.FORWARD, 1);
        assertEquals(List.of(), letters(lab.holding().word()));
        assertTrue(lab.player().feet().x() < 7, lab.player().toString());
        assertStillHeld(lab);
        lab.hold(PlayerInput.NONE, 1);
        assertEquals(lab.player().feet().x() - HELD_METRES, lab.body(0).x(), 0.02);
    }

    @Test
    void thePlayerGoesFirstBackwards() {
        Lab lab = holding(hall().cube(new Vec3(0, 1.65, -5.7), 0.4, 20).startAt(0, 0, -7, 180, 0));
        lab.hold(PlayerInput.NONE.walking(-50, 0), 0.7);
        assertEquals(List.of(1), letters(lab.holding().word()));
        assertTrue(lab.player().feet().x() > 6 && lab.body(0).z() < -7, "either side: " + lab.body(0));
        lab.hold(PlayerInput.NONE.walking(-50, 0), 1);
        assertEquals(List.of(), letters(lab.holding().word()));
        assertTrue(lab.body(0).x() > 4);
        assertStillHeld(lab);
    }

    /** A player that steps forward and back leads the cube through the portal and back, three times. */
    @Test
    void steppingBackTakesItBack() {
        Lab lab = holding(hall().cube(new Vec3(0, 1.65, -6.3), 0.4, 20).startAt(0, 0, -5, 0, 0));
        for (int i = 0; i < 3; i++) {
            lab.hold(PlayerInput.FORWARD, 0.65).hold(PlayerInput.NONE, 0.3);
            assertEquals(List.of(0), letters(lab.holding().word()));
            lab.hold(PlayerInput.NONE.walking(-100, 0), 0.65).hold(PlayerInput.NONE, 0.3);
            assertEquals(List.of(), letters(lab.holding().word()));
        }
        assertStillHeld(lab);
    }

    @Test
    void severalPairsInARow() {
        Lab lab = holding(hall().cube(new Vec3(0, 1.65, -6.3), 0.4, 20).startAt(0, 0, -5, 0, 0));
        int[] crossings = new int[1];
        lab.hold(
                PlayerInput.FORWARD,
                7,
                state -> crossings[0] += state.world().trace().playerCrossed().length());
        // Into 0 ahead, out of 1 towards −x, into 2, out of 3 towards −z.
        assertEquals(2, crossings[0]);
        assertEquals(3, lab.player().feet().x(), 0.01);
        assertStillHeld(lab);
        lab.hold(PlayerInput.NONE, 1);
        assertEquals(lab.player().feet().z() - HELD_METRES, lab.body(0).z(), 0.02);
    }

    @Test
    void handsReachThroughAPortal() {
        Lab lab = holding(hall().cube(new Vec3(7.2, 1.55, 0), 0.4, 20).startAt(0, 0, -7.2, 0, -3));
        assertEquals(List.of(0), letters(lab.holding().word()));
        lab.turn(0, 3).hold(PlayerInput.NONE.walking(-100, 0), 0.6).hold(PlayerInput.NONE, 0.5);
        assertEquals(List.of(), letters(lab.holding().word()));
        assertStillHeld(lab);
    }

    /** A cube with its centre beyond a portal sticks out on this side, where it can be picked up too. */
    @Test
    void whatSticksOutIsGrasped() {
        Lab lab = hall().cube(new Vec3(7.95, 1.65, 0), 0.4, 20)
                .startAt(0, 0, -6.2, 0, 0)
                .press(Action.CARRY);
        assertTrue(lab.holding().isHolding(), lab.events().toString());
        assertEquals(List.of(0), letters(lab.holding().word()));
    }

    /** A cube thrown into a portal continues in the space behind it. */
    @Test
    void athrowGoesThrough() {
        Lab lab = holding(hall().cube(new Vec3(0, 1.65, -5.3), 0.4, 20).startAt(0, 0, -4, 0, 0));
        lab.hold(PlayerInput.NONE, 0.5).press(Action.THROW).hold(PlayerInput.NONE, 0.45);
        Vec3 speed = lab.state().world().bodies().state(0).velocity();
        assertEquals(-8, speed.x(), 1e-6);
        assertEquals(0, speed.z(), 1e-6);
        assertTrue(lab.body(0).x() < 8 && lab.body(0).x() > 6);
    }

    /** If a portal on the line moves away, the cube is dropped within the grace time and remains in free space. */
    @Test
    void aPortalMovedInBetweenBreaksTheLine() {
        Lab lab = holding(Lab.hall()
                .gun()
                .cube(new Vec3(0, 1.65, -1.3), 0.4, 20)
                .startAt(0, 0, 0, 0, -5)
                .turn(-90, 0)
                .press(Action.FIRE_SECOND)
                .turn(180, 0)
                .press(Action.FIRE_FIRST)
                .turn(-90, 5));
        int before = lab.events().size();
        // Into the first portal, in the wall to the left, while the cube is ahead.
        lab.turn(90, 0).hold(PlayerInput.FORWARD, 1.85).hold(PlayerInput.NONE, 0.5);
        assertEquals(1, lab.holding().word().length(), lab.player().toString());
        lab.turn(-90, 0);
        long ticks = 0;
        lab.tick(PlayerInput.NONE.holding(Action.FIRE_SECOND));
        while (lab.holding().isHolding() && ticks < 1000) {
            lab.tick(PlayerInput.NONE);
            ticks++;
        }
        assertEquals(before + 2, lab.events().size(), lab.events().toString());
        assertEquals(new Handled(Kind.LOST, 0), lab.events().get(before + 1));
        assertTrue(ticks <= (long) (CarryRules.GRACE_SECONDS * 120) + 1, ticks + " ticks");
        lab.hold(PlayerInput.NONE, 2);
        assertEquals(0.2, lab.body(0).y(), 0.002);
        assertFalse(Math.abs(lab.body(0).x()) > 7.81 || Math.abs(lab.body(0).z()) > 7.81);
    }
}
