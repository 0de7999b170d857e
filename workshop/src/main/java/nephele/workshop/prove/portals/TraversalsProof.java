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
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Sends one body through random pairs and back through the same, without a restart, and checks that it returns to its
 * place: once as a point, directions and an orientation through the bare portal transforms, and as often again as
 * thrown bodies of the solver ({@link Flight}). The three axes are transformed as directions, which are never
 * normalised or made perpendicular again. The rounding of a passage and its return is the same each time, so that it
 * adds up; random paths would average it.
 */
public final class TraversalsProof implements Proof {
    private static final int PAIRS = 40;
    private static final double SPREAD_METRES = 100;
    private static final double MOST_OFF_METRES = 1e-6;
    private static final double MOST_OFF_SPEED = 1e-8;
    private static final double MOST_OFF_BASIS = 1e-9;
    /**
     * The largest dot product of normal and up; an up nearer than 0.8° to the normal does not define an orientation.
     */
    private static final double MOST_ALONG = 0.9999;
    /** The length of a chain of traversals; a proof over a million is one chain. */
    private static final long CHAIN = 1_000_000;

    @Override
    public Claim claim() {
        return new Claim(
                "traversals",
                "A million traversals of random portal pairs change neither position, speed nor orthonormal"
                        + " axes by more than rounding.",
                "traversals",
                CHAIN,
                CHAIN);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var random = new SplittableRandom(from);
        Traveller traveller = new Traveller(random);
        PortalTransform[][] transforms = transforms(random);
        for (long i = 0; i < count; i += 2) {
            PortalTransform[] pair = transforms[random.nextInt(PAIRS)];
            traveller.thereAndBack(pair[0], pair[1]);
            progress.unitsDone(i);
        }
        return traveller.result(count).and(new Flight(random).run(count));
    }

    /**
     * Returns the angle between two orientations in radians, for small angles: twice the length of the vector part of
     * q1* q2.
     */
    private static double turned(Quaterniond from, Quaterniond to) {
        Quaterniond between = from.conjugate(new Quaterniond()).mul(to);
        return 2 * Math.sqrt(between.x * between.x + between.y * between.y + between.z * between.z);
    }

    private static PortalTransform[][] transforms(SplittableRandom random) {
        PortalTransform[][] transforms = new PortalTransform[PAIRS][];
        for (int i = 0; i < PAIRS; i++) {
            Portal a = anywhere(random);
            Portal b = anywhere(random);
            transforms[i] = new PortalTransform[] {PortalTransform.between(a, b), PortalTransform.between(b, a)};
        }
        return transforms;
    }

    /** Returns a portal with normal and up uniform over the sphere. */
    private static Portal anywhere(SplittableRandom random) {
        Vec3 centre = new Vec3(
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES),
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES),
                random.nextDouble(-SPREAD_METRES, SPREAD_METRES));
        Vec3 normal = direction(random);
        Vec3 up = direction(random);
        while (Math.abs(normal.dot(up)) > MOST_ALONG) {
            up = direction(random);
        }
        return new Portal("end", centre, Portal.facing(normal, up), Aperture.of(PortalShape.ARCH, 1.2, 2.1));
    }

    /** Returns a direction, uniform over the sphere: z and the longitude are uniform (Archimedes). */
    private static Vec3 direction(SplittableRandom random) {
        double z = random.nextDouble(-1, 1);
        double longitude = random.nextDouble(2 * Math.PI);
        double around = Math.sqrt(1 - z * z);
        return Directions.unit(around * Math.cos(longitude), around * Math.sin(longitude), z);
    }

    /** A body that goes through a pair and returns through it, so that it should be at its initial place. */
    private static final class Traveller {
        private final Vector3d place;
        private final Vector3d velocity;
        private final Quaterniond orientation = new Quaterniond();
        private final Vector3d x = new Vector3d(1, 0, 0);
        private final Vector3d y = new Vector3d(0, 1, 0);
        private final Vector3d z = new Vector3d(0, 0, 1);
        private final Vector3d firstPlace;
        private final double firstSpeed;
        private final Quaterniond firstOrientation = new Quaterniond();
        private double worstSpeed;
        private double worstBasis;

        Traveller(SplittableRandom random) {
            place = new Vector3d(random.nextDouble(-50, 50), random.nextDouble(-50, 50), random.nextDouble(-50, 50));
            velocity = new Vector3d(random.nextDouble(1, 9), random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            firstPlace = new Vector3d(place);
            firstSpeed = velocity.length();
        }

        void thereAndBack(PortalTransform there, PortalTransform back) {
            go(there);
            go(back);
        }

        private void go(PortalTransform transform) {
            transform.point(place);
            transform.direction(velocity);
            transform.orientation(orientation);
            transform.direction(x);
            transform.direction(y);
            transform.direction(z);
            worstSpeed = Math.max(worstSpeed, Math.abs(velocity.length() / firstSpeed - 1));
            double skew = Math.max(Math.abs(x.dot(y)), Math.max(Math.abs(y.dot(z)), Math.abs(z.dot(x))));
            double stretch = Math.max(stretch(x), Math.max(stretch(y), stretch(z)));
            worstBasis = Math.max(worstBasis, Math.max(skew, stretch));
        }

        private static double stretch(Vector3d axis) {
            return Math.abs(axis.lengthSquared() - 1);
        }

        ProofResult result(long count) {
            double off = place.distance(firstPlace);
            double turned = turned(orientation, firstOrientation);
            List<String> failures = new ArrayList<>();
            if (!(off <= MOST_OFF_METRES)) {
                failures.add("the body is " + off + " m from its place");
            }
            if (!(worstSpeed <= MOST_OFF_SPEED)) {
                failures.add("its speed is off by " + worstSpeed);
            }
            if (!(worstBasis <= MOST_OFF_BASIS)) {
                failures.add("its axes are off orthonormal by " + worstBasis);
            }
            if (!(turned <= MOST_OFF_BASIS)) {
                failures.add("it is turned by " + turned);
            }
            return ProofResult.of(
                    count,
                    failures,
                    Figure.greatest("distance from its place", off, "m"),
                    Figure.greatest("speed off, of itself", worstSpeed, ""),
                    Figure.greatest("axes off orthonormal, never made unit again", worstBasis, ""),
                    Figure.greatest("orientation off", turned, "rad"));
        }
    }

    /**
     * Throws spinning cubes of the solver through one pair of portals each, under gravity. After the tick in which a cube
     * crosses, its velocity and spin are reversed: the next tick retraces the same arc through the pair, so that the cube
     * should return to its initial place, speed and orientation. (A cube's moments of inertia are equal, so that it spins
     * at a constant rate.)
     */
    private static final class Flight {
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

        Flight(SplittableRandom random) {
            List<Portal> ends = new ArrayList<>();
            List<Integer> partners = new ArrayList<>();
            List<Body> cubes = new ArrayList<>();
            for (int i = 0; i < PAIRS; i++) {
                Portal entry = anywhere(random);
                ends.add(entry);
                ends.add(anywhere(random));
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
            Vec3 centre = entry.world(
                    random.nextDouble(-0.2, 0.2), random.nextDouble(-0.4, 0.4), random.nextDouble(0.01, 0.06));
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
                double speed =
                        Math.abs(now.velocity().length() / then.velocity().length() - 1);
                double turn = turned(now.orientation(), then.orientation());
                farthest = Math.max(farthest, off);
                worstSpeed = Math.max(worstSpeed, speed);
                worstTurn = Math.max(worstTurn, turn);
                if (!(off <= MOST_OFF_METRES && speed <= MOST_OFF_SPEED && turn <= MOST_OFF_BASIS)) {
                    failures.add("flown cube " + i + " is off by " + off + " m, " + speed + " of its speed, " + turn
                            + " rad: " + now);
                }
            }
        }
    }
}
