package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
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
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/**
 * Drops a player, and then a spinning cube, a ball and a capsule, from 2 m into one floor portal, out of another and
 * back, ten thousand times at each of four tick rates, and measures the apex of each fall. A unit is a fall at the rate
 * of its number.
 */
public final class FallsProof implements Proof {
    private static final double HEIGHT_METRES = 2;
    private static final double MOST_OFF_METRES = 1e-6;
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);
    private static final Vec3 SPIN = new Vec3(1, 2, 3);
    private static final Vec3 CUBE = new Vec3(0.4, 0.4, 0.4);
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
            result = result.and(fallsOfPlayer(rate, end - unit)).and(fallsOfBodies(rate, end - unit));
            unit = end;
            progress.unitsDone(unit - from);
        }
        return result;
    }

    private static ProofResult fallsOfPlayer(int rate, long falls) {
        Simulation simulation = simulation(rate);
        SimState state = simulation.start();
        double worst = 0;
        long passes = 0;
        while (passes < falls) {
            state = simulation.step(state, PlayerInput.NONE);
            passes += state.world().trace().playerCrossed().length();
            worst = Math.max(
                    worst,
                    Math.abs(apex(
                                    state.player().centre().y(),
                                    state.player().velocity().y())
                            - HEIGHT_METRES));
            if (state.player().isGrounded()) {
                break;
            }
        }
        List<String> failures = new ArrayList<>();
        if (!(worst <= MOST_OFF_METRES) || passes < falls) {
            failures.add("at " + rate + " ticks a second, after " + passes + " falls: off by " + worst + " m");
        }
        return ProofResult.of(
                falls, failures, Figure.greatest("apex off 2 m at " + rate + " ticks a second", worst, "m"));
    }

    /** Drops bodies of the solver, each alone and {@code falls} times, at {@code rate} ticks a second. */
    private static ProofResult fallsOfBodies(int rate, long falls) {
        PortalWorld world = PortalWorld.of(floor(), portals());
        Vec3 middle = world.portals().portal(0).centre();
        Vec3 from = new Vec3(middle.x(), middle.y() + HEIGHT_METRES, middle.z());
        List<Body> bodies = List.of(
                new Body.Box("cube", from, CUBE, 1, null, 0.6, 0),
                new Body.Sphere("ball", from, 0.3, 1, null, 0.6, 0),
                new Body.Capsule("capsule", from, 0.2, 0.7, 1, null, 0.6, 0));
        ProofResult result = ProofResult.NOTHING;
        for (Body body : bodies) {
            result = result.and(falls(body, world, rate, falls));
        }
        return result;
    }

    private static ProofResult falls(Body body, PortalWorld world, int rate, long falls) {
        RigidStep step = new RigidStep(new BodyTable(List.of(body)), GRAVITY);
        Vec3 spin = body instanceof Body.Capsule ? Vec3.ZERO : SPIN;
        Bodies bodies = Bodies.of(List.of(BodyState.resting(body.centre()).moving(Vec3.ZERO, spin)));
        double worst = 0;
        long passes = 0;
        long idleTicks = 0;
        while (passes < falls && idleTicks < 10L * rate) {
            bodies = step.step(bodies, world, BodyInfluences.none(), 1.0 / rate);
            idleTicks = bodies.crossings(0) > 0 ? 0 : idleTicks + 1;
            passes += bodies.crossings(0);
            worst = Math.max(
                    worst,
                    Math.abs(apex(bodies.centre(0, new Vector3d()).y, bodies.velocity(0, new Vector3d()).y)
                            - HEIGHT_METRES));
        }
        List<String> failures = new ArrayList<>();
        if (!(worst <= MOST_OFF_METRES) || passes < falls) {
            failures.add("at " + rate + " ticks a second, after " + passes + " falls: " + body + " is off by " + worst
                    + " m");
        }
        return ProofResult.of(
                0,
                failures,
                Figure.sum("falls of a " + body.id(), passes, ""),
                Figure.greatest("apex of a " + body.id() + " off 2 m", worst, "m"));
    }

    /** Returns the height of the apex of a centre's arc, h + v² / 2 g, in metres. */
    private static double apex(double height, double upwardVelocity) {
        return height + upwardVelocity * upwardVelocity / (2 * PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED);
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
