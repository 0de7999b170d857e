package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Quaterniond;

/**
 * Throws spinning cubes of the solver through one pair of portals each, under gravity. After the tick in which a cube
 * crosses, its velocity and spin are reversed: the next tick retraces the same arc through the pair, so that the cube
 * should return to its initial place, speed and orientation. (A cube's moments of inertia are equal, so that it spins
 * at a constant rate.)
 */
final class FlownTraversals {
    private static final int PAIRS = 8;
    private static final double TICK_SECONDS = 1.0 / 60;
    private static final double CUBE_METRES = 0.2;
    private static final Vec3 GRAVITY = new Vec3(0, -9.81, 0);

    private final PortalWorld surroundings;
    private final RigidStep step;
    private final List<BodyState> first = new ArrayList<>();
    private final List<String> failures = new ArrayList<>();
    private double farthest;
    private double worstSpeed;
    private double worstTurn;

    FlownTraversals(SplittableRandom random) {
        List<Portal> ends = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        List<Body> cubes = new ArrayList<>();
        for (int i = 0; i < PAIRS; i++) {
            Portal entry = TraversalsProof.anywhere(random);
            ends.add(entry);
            ends.add(TraversalsProof.anywhere(random));
            partners.add(2 * i + 1);
            partners.add(2 * i);
            BodyState start = thrown(entry, random);
            first.add(start);
            Vec3 size = new Vec3(CUBE_METRES, CUBE_METRES, CUBE_METRES);
            cubes.add(new Body.Box("cube" + i, start.centre(), size, 1, null, 0.6, 0));
        }
        surroundings = PortalWorld.of(new CollisionWorld(List.of()), new Portals(ends, partners));
        step = new RigidStep(new BodyTable(cubes), GRAVITY);
    }

    /** Returns a cube near the middle of the aperture that passes through before the tick ends. */
    private static BodyState thrown(Portal entry, SplittableRandom random) {
        Vec3 centre =
                entry.world(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.4, 0.4), random.nextDouble(0.01, 0.06));
        Vec3 ahead = entry.world(random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2), -1);
        Vec3 velocity = ahead.minus(entry.centre()).scaled(random.nextDouble(6, 12));
        Vec3 spin = new Vec3(random.nextDouble(-5, 5), random.nextDouble(-5, 5), random.nextDouble(-5, 5));
        return new BodyState(centre, new Quaterniond(), velocity, spin);
    }

    ProofResult run(long count) {
        Bodies bodies = Bodies.of(first);
        long crossed = 0;
        while (crossed < count && failures.isEmpty()) {
            bodies = turnedAbout(through(turnedAbout(through(bodies))));
            compare(bodies);
            crossed += 2 * PAIRS;
        }
        return ProofResult.of(
                0,
                failures,
                Figure.sum("flown traversals", crossed, ""),
                Figure.greatest("flown, distance from its place", farthest, "m"),
                Figure.greatest("flown, speed off, of itself", worstSpeed, ""),
                Figure.greatest("flown, orientation off", worstTurn, "rad"));
    }

    private Bodies through(Bodies before) {
        Bodies after = step.step(before, surroundings, BodyInfluences.none(), TICK_SECONDS);
        for (int i = 0; i < PAIRS; i++) {
            if (after.crossings(i) != 1) {
                failures.add("cube " + i + " went through " + after.crossings(i) + " portals: " + after.state(i));
            }
        }
        return after;
    }

    private static Bodies turnedAbout(Bodies bodies) {
        List<BodyState> states = new ArrayList<>();
        for (int i = 0; i < PAIRS; i++) {
            BodyState state = bodies.state(i);
            states.add(state.moving(state.velocity().negated(), state.spin().negated()));
        }
        return Bodies.of(states);
    }

    private void compare(Bodies bodies) {
        for (int i = 0; i < PAIRS; i++) {
            BodyState now = bodies.state(i);
            BodyState then = first.get(i);
            double off = now.centre().toVector().distance(then.centre().toVector());
            double speed = Math.abs(now.velocity().length() / then.velocity().length() - 1);
            double turn = TraversalsProof.turned(now.orientation(), then.orientation());
            farthest = Math.max(farthest, off);
            worstSpeed = Math.max(worstSpeed, speed);
            worstTurn = Math.max(worstTurn, turn);
            if (!(off <= TraversalsProof.PLACE_BAR_METRES
                    && speed <= TraversalsProof.SPEED_BAR
                    && turn <= TraversalsProof.BASIS_BAR)) {
                failures.add("flown cube " + i + " is off by " + off + " m, " + speed + " of its speed, " + turn
                        + " rad: " + now);
            }
        }
    }
}
