package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A pair of portals back to back on a wall is a doorway without depth: a walk or a fall through it has the same path as
 * through a hole in a thin wall.
 */
final class DoorwayTest {
    private static final double THIN = 1e-6;
    private static final double WALL = 0.2;
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 SOUTH = new Vec3(0, 0, 1);
    private static final Vec3 NORTH = new Vec3(0, 0, -1);
    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private static Course withPortals() {
        return Course.onFloor()
                .box(-50, 0, -WALL, 50, 9, 0)
                .pair(new Vec3[] {new Vec3(0, 1.05, 0), SOUTH, UP}, new Vec3[] {new Vec3(0, 1.05, -WALL), NORTH, UP});
    }

    private static Course withHole() {
        double half = THIN / 2;
        return Course.onFloor()
                .box(-50, 0, -half, -0.6, 9, half)
                .box(0.6, 0, -half, 50, 9, half)
                .box(-0.6, 2.1, -half, 0.6, 9, half);
    }

    /** Returns the path of the feet as if the wall had no thickness. */
    private static List<Vec3> unfolded(Course course, PlayerInput input, double seconds, Vec3 thickness) {
        List<Vec3> way = new ArrayList<>();
        boolean hasPortals = course.portals().size() > 0;
        course.hold(input, seconds, player -> {
            Vec3 p = player.feet();
            boolean beyond =
                    hasPortals && p.z() * thickness.z() + player.centre().y() * thickness.y() < 0;
            way.add(beyond ? new Vec3(p.x(), p.y() + thickness.y(), p.z() + thickness.z()) : p);
        });
        return way;
    }

    private static double farthest(List<Vec3> a, List<Vec3> b) {
        double most = 0;
        for (int i = 0; i < a.size(); i++) {
            double x = a.get(i).x() - b.get(i).x();
            double y = a.get(i).y() - b.get(i).y();
            double z = a.get(i).z() - b.get(i).z();
            most = Math.max(most, Math.sqrt(x * x + y * y + z * z));
        }
        return most;
    }

    /**
     * The capsule's path agrees within 1 mm: straight, off-centre, oblique against either jamb, at three tick rates.
     */
    @ParameterizedTest
    @CsvSource({
        "1, 0, false, 0.0, 0.01",
        "30, 10, false, -0.2, 0.5",
        "100, 0, false, 0.1, 1.5",
        "100, 60, false, -0.25, 1.0",
        "100, -100, false, 0.29, 0.8",
        "100, 0, true, 0.2, 1.5",
        "100, 30, true, -0.5, 1.5"
    })
    void walksAsThroughADoorway(int forward, int right, boolean runs, double x, double z) {
        PlayerInput input = PlayerInput.NONE.walking(forward, right);
        if (runs) {
            input = input.holding(Action.RUN);
        }
        for (int rate : new int[] {30, 120, 240}) {
            Course portals = withPortals().startAt(x, 0, z).ticksPerSecond(rate);
            Course hole = withHole().startAt(x, 0, z).ticksPerSecond(rate);
            List<Vec3> through = unfolded(portals, input, 2, new Vec3(0, 0, WALL));
            List<Vec3> door = unfolded(hole, input, 2, Vec3.ZERO);
            assertTrue(door.get(door.size() - 1).z() < -0.05, "gets through: " + door.get(door.size() - 1));
            double off = farthest(through, door);
            assertTrue(off <= 1e-3, "off by " + off + " at " + rate);
            double highest = through.stream().mapToDouble(Vec3::y).max().orElseThrow();
            double lowest = through.stream().mapToDouble(Vec3::y).min().orElseThrow();
            assertTrue(lowest >= -1e-3 && highest <= 1e-3, "on the floor: " + lowest + " to " + highest);
        }
    }

    /** The path of a fall through a floor agrees, straight and sliding down an edge. */
    @ParameterizedTest
    @CsvSource({"0, 0.0", "0, 0.25", "0, 0.35", "-12, 0.1"})
    void fallsAsThroughAHole(int right, double x) {
        PlayerInput input = PlayerInput.NONE.walking(0, right);
        for (int rate : new int[] {30, 120, 240}) {
            Course portals = new Course()
                    .box(-50, -WALL, -50, 50, 0, 50)
                    .box(-50, -9, -50, 50, -8, 50)
                    .pair(new Vec3[] {Vec3.ZERO, UP, SOUTH}, new Vec3[] {new Vec3(0, -WALL, 0), DOWN, SOUTH})
                    .startAt(x, 3, 0)
                    .ticksPerSecond(rate);
            double half = THIN / 2;
            Course hole = new Course()
                    .box(-50, -half, -50, -0.6, half, 50)
                    .box(0.6, -half, -50, 50, half, 50)
                    .box(-0.6, -half, 1.05, 0.6, half, 50)
                    .box(-0.6, -half, -50, 0.6, half, -1.05)
                    .box(-50, -9 + WALL, -50, 50, -8 + WALL, 50)
                    .startAt(x, 3, 0)
                    .ticksPerSecond(rate);
            List<Vec3> through = unfolded(portals, input, 1.2, new Vec3(0, WALL, 0));
            List<Vec3> door = unfolded(hole, input, 1.2, Vec3.ZERO);
            assertTrue(door.get(door.size() - 1).y() < -1, "falls through: " + door.get(door.size() - 1));
            double off = farthest(through, door);
            assertTrue(off <= 1e-3, "off by " + off + " at " + rate);
        }
    }

    /** A wait half-way changes no bit; the way back agrees with that of a doorway. */
    @Test
    void waitsHalfWayAndStepsBack() {
        for (double z : new double[] {0.5, 0.9}) {
            Course portals = withPortals().startAt(0.05, 0, z);
            Course hole = withHole().startAt(0.05, 0, z);
            for (Course course : List.of(portals, hole)) {
                course.hold(PlayerInput.FORWARD, 0.2).hold(PlayerInput.NONE, 1);
                PlayerState waiting = course.state().player();
                assertTrue(Math.abs(waiting.feet().z() + (z < 0.6 ? WALL : 0)) < 0.3, "half-way: " + waiting);
                course.hold(PlayerInput.NONE, 10_000 / 120.0, player -> assertEquals(waiting, player));
            }
            List<Vec3> through = unfolded(portals, PlayerInput.NONE.walking(-100, 20), 1, new Vec3(0, 0, WALL));
            List<Vec3> door = unfolded(hole, PlayerInput.NONE.walking(-100, 20), 1, Vec3.ZERO);
            assertEquals(0, farthest(through, door), 1e-9);
            assertEquals(
                    hole.state().player().heading(), portals.state().player().heading());
        }
    }
}
