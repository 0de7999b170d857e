package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.Sweep;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Throws players in closed rooms, at up to 10 000 m/s, and checks that none leaves the room or penetrates a wall. */
public final class ClosedRoomProof implements Proof {
    private static final long STARTS_PER_ROOM = 50;
    private static final int THROWS_PER_START = 3;
    private static final int TICKS_PER_THROW = 4;
    private static final int PLACES_TRIED = 30;
    private static final double MAX_METRES_PER_SECOND = 10_000;
    /** A player that falls out of the world restarts here, where the check detects it. */
    private static final PlayerStart FAR_AWAY = new PlayerStart(new Vec3(1e5, 1e5, 1e5), 0, 0);

    @Override
    public Claim claim() {
        return new Claim(
                "closed-room",
                "A player never leaves a closed room nor reaches into its walls, for any start, direction and speed up"
                        + " to 10 000 m/s.",
                "starts",
                1_000_000,
                100_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var run = new Run();
        for (long unit = from; unit < from + count; unit++) {
            run.test(unit);
            progress.unitsDone(unit + 1 - from);
        }
        return run.result(count);
    }

    /** The throws in one room after another, and their results. */
    private static final class Run {
        private final Depenetration depenetration = new Depenetration();
        private final Vector3d place = new Vector3d();
        private long roomNumber = -1;
        private ClosedRoom room;
        private Simulation simulation;
        private final List<String> escapes = new ArrayList<>();
        private long ticks;
        private long fastTicks;
        private double leastClearance = Double.POSITIVE_INFINITY;
        private double skinLost;

        void test(long unit) {
            if (roomNumber != unit / STARTS_PER_ROOM) {
                roomNumber = unit / STARTS_PER_ROOM;
                room = ClosedRoom.of(new SplittableRandom(roomNumber));
                simulation = new Simulation(room.world(), FAR_AWAY, SimSettings.DEFAULT);
            }
            var random = new SplittableRandom(~unit);
            SimState state = start(random);
            double clearance = room.clearance(state.player());
            for (int i = 0; i < THROWS_PER_START; i++) {
                Vec3 velocity = velocity(random);
                fastTicks += velocity.length() > 1000 ? 1 : 0;
                state = new SimState(state.tick(), 0, 0, state.player().withVelocity(velocity));
                for (int k = 0; k < TICKS_PER_THROW; k++) {
                    state = simulation.step(state, input(random));
                    look(unit, state, clearance);
                }
            }
        }

        /** @param atStart clearance of the start, which may be less than the skin */
        private void look(long unit, SimState state, double atStart) {
            double clearance = room.clearance(state.player());
            ticks++;
            leastClearance = Math.min(leastClearance, clearance);
            skinLost = Math.max(skinLost, Math.min(atStart, Sweep.SKIN_METRES) - clearance);
            if (clearance < 0 || state.faults() > 0) {
                escapes.add(String.format(Locale.ROOT, "start %d: %.6f m from the wall, %s", unit, clearance, state));
            }
        }

        ProofResult result(long units) {
            return ProofResult.of(
                    units,
                    escapes,
                    Figure.sum("escapes", escapes.size(), ""),
                    Figure.sum("ticks", ticks, ""),
                    Figure.sum("throws above 1000 m/s", fastTicks, ""),
                    Figure.least("least distance from a wall", leastClearance * 1000, "mm"),
                    Figure.greatest("most of the 1 mm skin that was lost", skinLost * 1e6, "µm"));
        }

        /** Returns a random free place; the room's middle if no try is free. */
        private SimState start(SplittableRandom random) {
            ViewAngles heading = ViewAngles.ofDegrees(360 * random.nextDouble(), 0);
            for (int i = 0; i < PLACES_TRIED; i++) {
                PlayerState player = PlayerState.standing(room.somewhere(random), heading);
                if (isFree(player)) {
                    return new SimState(0, 0, 0, player);
                }
            }
            PlayerState middle = PlayerState.standing(new Vec3(0, -Stance.STANDING.centreAboveFeet(), 0), heading);
            if (!isFree(middle)) {
                throw new IllegalStateException("room " + roomNumber + " has no room");
            }
            return new SimState(0, 0, 0, middle);
        }

        private boolean isFree(PlayerState player) {
            Vec3 feet = player.feet();
            place.set(feet.x(), feet.y() + Stance.STANDING.centreAboveFeet(), feet.z());
            return room.clearance(player) > 0 && depenetration.isFree(room.world(), Stance.STANDING.shape(), place);
        }

        /**
         * Returns a velocity in any direction, sometimes with components of 0; from 0.1 m/s to 10 000 m/s, a quarter of
         * them at 10 000 m/s.
         */
        private static Vec3 velocity(SplittableRandom random) {
            double speed = random.nextInt(4) == 0
                    ? MAX_METRES_PER_SECOND
                    : MAX_METRES_PER_SECOND * StrictMath.pow(10, -5 * random.nextDouble());
            Vec3 d = new Vec3(component(random), component(random), component(random));
            double length = d.length();
            return length == 0
                    ? new Vec3(0, -speed, 0)
                    : new Vec3(d.x() / length * speed, d.y() / length * speed, d.z() / length * speed);
        }

        private static double component(SplittableRandom random) {
            return random.nextInt(6) == 0 ? 0 : 2 * random.nextDouble() - 1;
        }

        private static PlayerInput input(SplittableRandom random) {
            return new PlayerInput(random.nextInt(-100, 101), random.nextInt(-100, 101), 0, 0, random.nextInt(8));
        }
    }
}
