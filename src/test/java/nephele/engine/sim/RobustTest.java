package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.prove.geometry.BruteForce;
import nephele.workshop.prove.geometry.ObstacleCourse;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RobustTest {
    /** The same walk a thousand kilometres away ends within a micrometre. */
    @ParameterizedTest
    @CsvSource({"1048576, 0, -1048576", "-1000000, 1000, 1000000", "1000000.3, 0.7, 999999.9"})
    void farOutIsAsNearTheOrigin(double x, double y, double z) {
        Course near = new Course(ObstacleCourse.at(Vec3.ZERO), Vec3.ZERO);
        Course far = new Course(ObstacleCourse.at(new Vec3(x, y, z)), new Vec3(x, y, z));
        var random = new SplittableRandom(4);
        double worst = 0;
        for (int i = 0; i < 60; i++) {
            PlayerInput input = ObstacleCourse.anything(random);
            near.hold(input, 0.25);
            far.hold(input, 0.25);
            worst = Math.max(worst, Math.abs(far.feet().x() - x - near.feet().x()));
            worst = Math.max(worst, Math.abs(far.feet().y() - y - near.feet().y()));
            worst = Math.max(worst, Math.abs(far.feet().z() - z - near.feet().z()));
        }
        assertTrue(worst <= 1e-6, "off by " + worst + " m");
    }

    /** A player that starts inside a solid is pushed out, a little each tick. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.1, 0.29, 0.31, 0.5, 1, 1.5})
    void aStartInsideASolidIsLeft(double depth) {
        Course course = Course.onFloor().box(-2, 0, -5, 2, 4, -1).startAt(0.3, 0.2, -1.3 - depth + 0.6);
        List<Vec3> way = new ArrayList<>(List.of(course.feet()));
        course.hold(PlayerInput.NONE, 3, player -> {
            Vector3d step = player.feet().toVector().sub(way.get(way.size() - 1).toVector());
            assertTrue(step.length() < 0.1, () -> "jumped by " + step.length());
            way.add(player.feet());
        });
        assertTrue(BruteForce.gap(course.state().player(), course.world()) >= 0);
        assertTrue(course.state().player().isGrounded());
    }

    @Test
    void aStartBetweenSolidsThatOverlapIsLeft() {
        Course course = Course.onFloor()
                .box(-1, 0, -2, 0.1, 3, 2)
                .box(-0.1, 0, -2, 1, 3, 2)
                .box(-3, 0, -0.2, 3, 3, 0.2);
        course.startAt(0, 0.1, 0).hold(PlayerInput.NONE, 4);
        assertTrue(BruteForce.gap(course.state().player(), course.world()) >= 0);
        course.hold(PlayerInput.FORWARD, 0.2);
        assertEquals(0, course.state().faults());
    }

    /** NaN keeps the last valid place, and is counted as a fault. */
    @Test
    void whatIsNotANumberIsUndoneAndCounted() {
        Course course = Course.onFloor();
        Simulation simulation = new Simulation(course.world(), null, SimSettings.DEFAULT);
        SimState good = simulation.start();
        Vec3 feet = good.player().feet();
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, -1e308}) {
            SimState broken = new SimState(7, 1, 0, good.player().withVelocity(new Vec3(bad, 0, 1e308)));
            SimState after = simulation.step(broken, PlayerInput.FORWARD);
            assertEquals(8, after.tick());
            assertTrue(after.player().feet().toVector().isFinite());
            if (Double.isNaN(bad)) {
                assertEquals(feet, after.player().feet());
                assertEquals(Vec3.ZERO, after.player().velocity());
                assertEquals(1, after.faults());
            }
        }
        Vec3 nowhere = new Vec3(Double.NaN, 0, 0);
        SimState lost = simulation.step(new SimState(0, 1, 0, good.player().withFeet(nowhere)), PlayerInput.NONE);
        assertEquals(feet, lost.player().feet());
    }

    @Test
    void everyPartOfTheStateIsInItsHash() {
        SimState state = Course.onFloor().hold(PlayerInput.FORWARD, 0.1).state();
        PlayerState p = state.player();
        List<SimState> others = List.of(
                new SimState(state.tick() + 1, 1, 0, p),
                new SimState(state.tick(), 2, 0, p),
                new SimState(state.tick(), 1, 1, p),
                new SimState(
                        state.tick(),
                        1,
                        0,
                        p.withVelocity(new Vec3(0, 0, Math.nextUp(p.velocity().z())))),
                new SimState(
                        state.tick(),
                        1,
                        0,
                        p.withFeet(new Vec3(Math.nextUp(p.feet().x()), 0, 0))),
                new SimState(
                        state.tick(),
                        1,
                        0,
                        new PlayerState(
                                p.feet(),
                                p.velocity(),
                                p.heading().turned(1, 0),
                                p.eyeMetres(),
                                p.stance(),
                                p.ground(),
                                false)),
                new SimState(
                        state.tick(),
                        1,
                        0,
                        new PlayerState(
                                p.feet(), p.velocity(), p.heading(), p.eyeMetres(), p.stance(), p.ground(), true)));
        for (SimState other : others) {
            assertNotEquals(state.hash(), other.hash());
        }
        assertEquals(state.hash(), new SimState(state.tick(), 1, 0, p).hash());
    }

    /** The simulation allocates at most 4 KiB a tick. */
    @Test
    void aTickAllocatesLittle() {
        Course course = new Course(ObstacleCourse.at(Vec3.ZERO), Vec3.ZERO);
        var random = new SplittableRandom(11);
        PlayerInput[] inputs =
                random.ints(100).mapToObj(i -> ObstacleCourse.anything(random)).toArray(PlayerInput[]::new);
        Simulation simulation = course.simulation();
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        SimState state = run(simulation, course.state(), inputs, 5000);
        long before = threads.getCurrentThreadAllocatedBytes();
        run(simulation, state, inputs, 5000);
        long perTick = (threads.getCurrentThreadAllocatedBytes() - before) / 5000;
        assertTrue(perTick <= 4096, perTick + " bytes a tick");
    }

    private static SimState run(Simulation simulation, SimState from, PlayerInput[] inputs, int ticks) {
        SimState state = from;
        for (int i = 0; i < ticks; i++) {
            state = simulation.step(state, inputs[i / 30 % inputs.length]);
        }
        return state;
    }
}
