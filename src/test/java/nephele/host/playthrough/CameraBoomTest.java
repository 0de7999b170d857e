package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.prove.portals.DoorwayRooms;
import nephele.workshop.prove.portals.DoorwayRooms.Doors;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The third-person camera, beside and beyond portals. */
class CameraBoomTest {
    private static final double TICK = 1.0 / 120;
    private static final int SHARES = 4;
    /** A doorway's boom is slightly shortened by solids close behind the thin wall; a portal's is not. */
    private static final double MOST_OFF_METRES = 0.005;

    /** Any division of the time into frames gives the same camera: the spring's step is exact. */
    @Test
    void anyCutOfTheTimeGivesTheSameSpring() {
        var random = new Random(5);
        for (int round = 0; round < 1000; round++) {
            var start = new CameraBoomState(
                    new CameraSpring(vector(random), vector(random)), vector(random), random.nextDouble());
            double wanted = round % 2;
            double seconds = random.nextDouble() * 0.3;
            CameraBoomState cut = start;
            double left = seconds;
            for (int piece = 0; piece < 5; piece++) {
                double part = left * random.nextDouble();
                cut = cut.after(part, wanted);
                left -= part;
            }
            cut = cut.after(left, wanted);
            CameraBoomState whole = start.after(seconds, wanted);
            assertEquals(whole.extent(), cut.extent(), 1e-12);
            assertEquals(0, distance(whole.spring().lag(), cut.spring().lag()), 1e-12);
            assertEquals(0, distance(whole.spring().velocity(), cut.spring().velocity()), 1e-11);
        }
    }

    /** Through 0 to 3 portals the boom ends in front of the wall behind the last one. */
    @Test
    void theWallAtTheWordsEndShortensTheBoom() {
        for (int doors = 0; doors <= 3; doors++) {
            for (double wall : new double[] {0.6, 0.9}) {
                Level level = TightRow.level(doors, wall);
                Portals portals = Portals.of(level);
                var reach = new CameraBoomReach(CollisionWorld.of(level));
                Vector3d eye = new Vector3d(0, 1.5, 0);
                Vector3d boom = new Vector3d(0, 0, 4);
                double free = reach.free(portals, eye, boom) * boom.length();
                double toWall = TightRow.TO_DOOR * doors + wall;
                assertEquals(toWall - CameraBoomReach.CLEARANCE_METRES, free, 1e-3, doors + " doors, wall " + wall);
                var trace = reach.trace(portals);
                trace.trace(eye, boom.mul(free / boom.length()));
                assertEquals(doors, trace.crossings());
                assertEquals(doors, trace.word().length());
            }
        }
    }

    /**
     * A wall in front of the player does not shorten the boom, nor does one that the shoulder touches behind the eye.
     */
    @Test
    void theWallThatOneFacesLeavesTheBoomOut() {
        Level level = new RoomLevel().box(-3, 0, -0.6, 3, 4, -0.3).level();
        var reach = new CameraBoomReach(CollisionWorld.of(level));
        for (double right = 0; right < 3; right += 0.25) {
            assertEquals(1, reach.free(Portals.of(level), new Vector3d(0, 1.5, 0), new Vector3d(right, 0.3, 2.6)), 0);
        }
    }

    /** For any walk and view, the boom through portals equals the boom through doorways of the same shape. */
    @Test
    void portalsAreDoorwaysToTheBoom() {
        int exact = 0;
        int all = 0;
        for (int doors = 0; doors <= 3; doors++) {
            List<Vec3> open = arms(DoorwayRooms.level(doors, Doors.OPEN), SHARES);
            List<Vec3> through = arms(DoorwayRooms.level(doors, Doors.PORTALS), SHARES);
            for (int i = 0; i < open.size(); i++) {
                double off = distance(open.get(i), through.get(i));
                assertEquals(0, off, MOST_OFF_METRES, doors + " doors, frame " + i);
                exact += off < 1e-9 ? 1 : 0;
                all++;
            }
        }
        assertTrue(exact > 0.9 * all, exact + " of " + all + " frames");
    }

    /** The boom is continuous: four times as many frames move it a quarter as far, and it extends at a limited rate. */
    @Test
    void theBoomNeverPops() {
        Level level = DoorwayRooms.level(2, Doors.PORTALS);
        double coarse = greatestStep(arms(level, SHARES), false);
        double fine = greatestStep(arms(level, 4 * SHARES), false);
        assertTrue(coarse > 0.01, "the boom hardly moves");
        assertTrue(fine < 0.3 * coarse, coarse + " and " + fine);
        double growth = greatestStep(arms(level, SHARES), true) / (TICK / SHARES);
        assertTrue(growth < CameraBoomState.EXTENDING_EXTENTS_PER_SECOND * 3.2 + 0.3, growth + " m/s");
    }

    private static double greatestStep(List<Vec3> arms, boolean ofLength) {
        double most = 0;
        for (int i = 1; i < arms.size(); i++) {
            double step =
                    ofLength ? length(arms.get(i)) - length(arms.get(i - 1)) : distance(arms.get(i), arms.get(i - 1));
            most = Math.max(most, step);
        }
        return most;
    }

    /**
     * Returns the boom in the view's axes, several times a tick, on a walk through all doors with a look around in
     * each.
     */
    private static List<Vec3> arms(Level level, int shares) {
        var simulation = new Simulation(level, SimSettings.DEFAULT);
        var boom = new CameraBoom(CollisionWorld.of(level), TICK);
        boom.toggle();
        List<Vec3> arms = new ArrayList<>();
        SimState after = simulation.start();
        for (int tick = 0; tick < 480; tick++) {
            int turn = (int) Math.round(600 * Math.sin(tick * 0.02));
            SimState before = after;
            after = simulation.step(after, PlayerInput.FORWARD.turning(turn, turn / 4));
            boom.tick(before, after);
            for (int share = 0; share < shares; share++) {
                arms.add(boom.offset(before, after, (double) share / shares));
            }
        }
        return arms;
    }

    private static Vec3 vector(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }

    private static double distance(Vec3 a, Vec3 b) {
        return a.toVector().distance(b.toVector());
    }

    private static double length(Vec3 v) {
        return v.toVector().length();
    }
}
