package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Throws a box, a ball or a capsule through a pair of portals, repeatedly, at up to 100 m/s and with spin. */
final class CrossingBodies {
    /** A smaller depth in a solid counts as contact, because the solver allows a little penetration. */
    private static final double PRESSED_METRES = 0.01;

    private static final double MIN_HALF_METRES = 0.1;
    private static final double MAX_HALF_METRES = 0.4;
    private static final double SECONDS_BEFORE = 0.33;
    private static final double SECONDS_AFTER = 0.25;
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private final PortalRoom room;
    private final SeamedClearance clearance;
    private final PortalWorld surroundings;
    private final BodyTable table;
    private final RigidStep step;
    /** Points of the body's surface relative to its centre, before any rotation. */
    private final List<Vector3d> points;

    private final double seconds;
    private final BodyInfluences influences = BodyInfluences.none();
    private final Depenetration depenetration = new Depenetration();
    private final Vector3d centre = new Vector3d();
    private final Quaterniond orientation = new Quaterniond();

    CrossingBodies(PortalRoom room, int ticksPerSecond, long number) {
        this.room = room;
        clearance = new SeamedClearance(room);
        surroundings = PortalWorld.of(room.world(), room.portals());
        seconds = 1.0 / ticksPerSecond;
        var random = new SplittableRandom(~number);
        double half = random.nextDouble(MIN_HALF_METRES, MAX_HALF_METRES);
        Body body;
        // One in four is a ball and one a capsule; two in three boxes are cubes.
        switch (random.nextInt(4)) {
            case 0 -> {
                body = new Body.Sphere("ball", Vec3.ZERO, half, 10, null, 0.6, 0.4);
                points = onBall(half);
            }
            case 1 -> {
                double straight = random.nextDouble(0, 2 * MAX_HALF_METRES);
                body = new Body.Capsule("capsule", Vec3.ZERO, half, straight + 2 * half, 10, null, 0.6, 0.2);
                points = onCapsule(half, straight);
            }
            default -> {
                double depth = random.nextInt(3) > 0 ? half : random.nextDouble(MIN_HALF_METRES, MAX_HALF_METRES);
                body = new Body.Box("box", Vec3.ZERO, new Vec3(2 * half, 2 * half, 2 * depth), 10, null, 0.6, 0.2);
                points = onBox(new Vec3(half, half, depth));
            }
        }
        table = new BodyTable(List.of(body));
        step = new RigidStep(table, GRAVITY);
    }

    private static List<Vector3d> onBox(Vec3 half) {
        List<Vector3d> points = new ArrayList<>();
        for (int i = 0; i < 27; i++) {
            if (i != 13) {
                points.add(new Vector3d((i % 3 - 1) * half.x(), (i / 3 % 3 - 1) * half.y(), (i / 9 - 1) * half.z()));
            }
        }
        return points;
    }

    private static List<Vector3d> onBall(double radius) {
        List<Vector3d> points = onBox(new Vec3(1, 1, 1));
        points.forEach(point -> point.normalize(radius));
        return points;
    }

    /** @param straight metres between the centres of its caps */
    private static List<Vector3d> onCapsule(double radius, double straight) {
        List<Vector3d> points = new ArrayList<>();
        for (Vector3d point : onBall(radius)) {
            points.add(new Vector3d(point).add(0, straight / 2, 0));
            points.add(new Vector3d(point).sub(0, straight / 2, 0));
        }
        return points;
    }

    Body body() {
        return table.body(0);
    }

    /** Draws starts until the body goes through, and returns true if it did. */
    boolean cross(SplittableRandom random, String where, CrossingTally tally) {
        for (int i = 0; i < CrossingsProof.MOST_TRIES; i++) {
            BodyState start = start(random);
            if (start != null && crosses(where, start, tally)) {
                return true;
            }
        }
        return false;
    }

    private boolean crosses(String where, BodyState start, CrossingTally tally) {
        Bodies bodies = Bodies.of(List.of(start));
        int last = (int) Math.ceil(SECONDS_BEFORE / seconds);
        boolean crossed = false;
        for (int tick = 0; tick < last; tick++) {
            bodies = step.step(bodies, surroundings, influences, seconds);
            if (!crossed && bodies.crossings(0) > 0) {
                crossed = true;
                last = tick + 1 + (int) Math.ceil(SECONDS_AFTER / seconds);
            }
        }
        if (crossed) {
            tallyEnd(where, bodies, start, tally);
        }
        return crossed;
    }

    /**
     * Records the end of a crossing. An impact may press the body into or even through a solid for a moment; it has a
     * second to leave it.
     */
    private void tallyEnd(String where, Bodies after, BodyState start, CrossingTally tally) {
        Bodies bodies = after;
        for (double waited = 0; !isWell(bodies) && waited < 1; waited += seconds) {
            bodies = step.step(bodies, surroundings, influences, seconds);
        }
        double depth = depth(bodies.state(0));
        if (!isInside(bodies)) {
            tally.escaped(where + ": out of the room: " + bodies.state(0) + of(start));
        } else if (depth > PRESSED_METRES) {
            tally.stuck(where + ": " + depth + " m in a solid: " + bodies.state(0) + of(start));
        } else {
            tally.bodyDepth(depth);
        }
    }

    private boolean isWell(Bodies bodies) {
        return isInside(bodies) && depth(bodies.state(0)) <= PRESSED_METRES;
    }

    private boolean isInside(Bodies bodies) {
        return room.holds(Vec3.of(bodies.centre(0, centre))) && bodies.frozen() == 0;
    }

    private String of(BodyState start) {
        return " of " + table.body(0) + " from " + start;
    }

    private double depth(BodyState state) {
        List<Vector3d> turned = new ArrayList<>();
        points.forEach(point -> turned.add(state.orientation().transform(new Vector3d(point))));
        return clearance.depth(state.centre().toVector(), turned);
    }

    /** Returns a start in front of one of the portals, moving towards it; {@code null} if no draw is free. */
    private BodyState start(SplittableRandom random) {
        for (int i = 0; i < 20; i++) {
            Portal entry = room.portals().portal(random.nextInt(2));
            Vec3 from = entry.world(
                    random.nextDouble(-0.5, 0.5), random.nextDouble(-0.9, 0.9), random.nextDouble(0.01, 0.8));
            Vec3 n = entry.normal();
            double speed = StrictMath.pow(10, random.nextDouble(-1, 2)) + (n.y() < -0.1 ? 4 : 0);
            Vec3 velocity = new Vec3(
                    -n.x() * speed + random.nextDouble(-1, 1),
                    -n.y() * speed + random.nextDouble(-1, 1),
                    -n.z() * speed + random.nextDouble(-1, 1));
            Vec3 axis = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            Vec3 spin = random.nextInt(3) == 0 ? Vec3.ZERO : axis.scaled(10);
            orientation.set(Rotations.aroundAxis(axis, random.nextDouble(0, 3)));
            BodyState state = new BodyState(from, new Quaterniond(orientation), velocity, spin);
            if (room.holds(from) && isFree(state)) {
                return state;
            }
        }
        return null;
    }

    private boolean isFree(BodyState state) {
        RoundedHull hull = table.hull(0, state.orientation());
        centre.set(state.centre().x(), state.centre().y(), state.centre().z());
        long active = surroundings.active(hull, centre, new Vector3d());
        return depenetration.isFree(surroundings.openedFor(active), hull, centre) && depth(state) == 0;
    }
}
