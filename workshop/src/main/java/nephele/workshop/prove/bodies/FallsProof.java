package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Drops a player, and then a spinning cube, a ball and a capsule, from 2 m into one floor portal, out of another and
 * back, ten thousand times at each of four tick rates, and measures the apex of each fall. A unit is a fall at the rate
 * of its number.
 */
public final class FallsProof implements Proof {
    static final double HEIGHT_METRES = 2;
    static final double BAR_METRES = 1e-6;
    private static final int[] RATES = {30, 60, 120, 240};
    private static final long FALLS = 10_000;

    @Override
    public Claim claim() {
        return new Claim(
                "falls",
                "A body that falls from floor portal to floor portal rises to the height from which it fell,"
                        + " ten thousand times, at any tick rate.",
                "falls",
                FALLS * RATES.length,
                FALLS);
    }

    /** Runs units; each rate has a continuous run of its own, so that a range is split where the next rate begins. */
    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        long unit = from;
        while (unit < from + count) {
            long end = Math.min(from + count, (unit / FALLS + 1) * FALLS);
            int rate = RATES[(int) (unit / FALLS % RATES.length)];
            result = result.and(falls(rate, end - unit))
                    .and(new FallingBodies(PortalWorld.of(floor(), portals())).run(rate, end - unit));
            unit = end;
            progress.unitsDone(unit - from);
        }
        return result;
    }

    private static ProofResult falls(int rate, long falls) {
        Simulation simulation = simulation(rate);
        SimState state = simulation.start();
        double worst = 0;
        long passes = 0;
        while (passes < falls) {
            state = simulation.step(state, PlayerInput.NONE);
            passes += state.world().trace().playerCrossed().length();
            worst = Math.max(worst, Math.abs(apex(state.player()) - HEIGHT_METRES));
            if (state.player().isGrounded()) {
                break;
            }
        }
        List<String> failures = new ArrayList<>();
        if (!(worst <= BAR_METRES) || passes < falls) {
            failures.add("at " + rate + " ticks a second, after " + passes + " falls: off by " + worst + " m");
        }
        return ProofResult.of(
                falls, failures, Figure.greatest("apex off 2 m at " + rate + " ticks a second", worst, "m"));
    }

    /** Returns the height of the apex of the centre's arc, h + v² / 2 g, in metres. */
    private static double apex(PlayerState player) {
        double v = player.velocity().y();
        return player.centre().y() + v * v / (2 * PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED);
    }

    private static Simulation simulation(int rate) {
        return new Simulation(
                SimLevel.of(
                        floor(),
                        new PlayerStart(new Vec3(-3, HEIGHT_METRES - Stance.STANDING.centreAboveFeet(), 0), 0, 0),
                        portals()),
                new SimSettings(rate, List.of()));
    }

    private static CollisionWorld floor() {
        Aabb floor = new Aabb(-50, -1, -50, 50, 0, 50);
        return new CollisionWorld(List.of(new Collider("floor", ConvexPolyhedron.box(floor))));
    }

    private static Portals portals() {
        Aperture aperture = Aperture.of(PortalShape.ARCH, 1.2, 2.1);
        var up = new Vec3(0, 1, 0);
        var first = new Portal("a", new Vec3(-3, 0, 0), Portal.facing(up, new Vec3(0, 0, -1)), aperture);
        var second = new Portal("b", new Vec3(3, 0, 0), Portal.facing(up, new Vec3(1, 0, 0)), aperture);
        return new Portals(List.of(first, second), List.of(1, 0));
    }
}
