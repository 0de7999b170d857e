package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.ContactCache;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.solver.ContactRows;
import nephele.engine.collision.rigid.solver.Islands;
import nephele.engine.collision.rigid.solver.SolverState;
import nephele.engine.collision.rigid.solver.StepSolver;
import nephele.engine.math.Vec3;

/**
 * Moves bodies by one tick: finds and solves contacts, moves bodies without contacts exactly, and puts resting bodies
 * to sleep. A long tick, or one in which a body in contact rotates far, is stepped in parts: contacts are linear in the
 * motion, but the path of a point of a rotating body is curved. Not thread-safe: the working set is reused.
 */
public final class RigidStep {
    /** Longer ticks are stepped in parts; contacts are found once in each part. */
    private static final double LONGEST_PART_SECONDS = 1 / 120.0;

    private static final int MOST_PARTS = 32;

    /** Limit of further parts of a part in which an impact makes a body rotate faster than before. */
    private static final int PARTS_AGAIN = 4;

    /**
     * Deviation from a straight path, of a point of a body in contact, above which contacts are found anew in between.
     */
    private static final double BEND_METRES = 3e-6;

    private static final int MOST_BENT_PARTS = 32;
    /** Limit of parts times awake bodies: finer parts are for few bodies. */
    private static final int MOST_BODY_STEPS = 64;

    /** Angle of rotation in a step below which the deviation is ignored. */
    private static final double LEAST_RADIANS = 1e-3;

    /** Time for which an island rests before it sleeps. */
    private static final float SLEEP_SECONDS = 0.5f;

    private static final double REST_METRES_PER_SECOND = 0.03;

    private final BodyTable table;
    private final Vec3 gravity;
    private final TickBodies bodies = new TickBodies();
    private final Poses poses = new Poses();
    private final SolverState motions = new SolverState();
    private final ContactRows rows = new ContactRows(motions);
    private final ContactSearch search;
    private final StepSolver solver;
    private final ContinuousMotion continuousMotion;
    private final Islands islands = new Islands();
    private float[] islandRest = new float[0];
    private boolean[] pressed = new boolean[0];
    private boolean[] hasContactImpulse = new boolean[0];
    /** True for bodies that {@link BodyInfluences} drives: a character holds them. */
    private boolean[] driven = new boolean[0];

    /** True for slots on which gravity acts. */
    private boolean[] hasGravity = new boolean[0];

    private int awake;

    /** What the bodies of this tick move in; and whether a part of the tick is over. */
    private PortalWorld world;

    private BodyInfluences around;
    private boolean hasBegun;
    /** Speeds of rotation of a body about each of its axes. */
    private final double[] axisSpeeds = new double[3];

    /** @param gravity m/s² */
    public RigidStep(BodyTable table, Vec3 gravity) {
        this.table = table;
        this.gravity = gravity;
        search = new ContactSearch(table, poses, motions, rows);
        solver = new StepSolver(table, gravity, motions, rows);
        continuousMotion = new ContinuousMotion(table, gravity, search, poses);
    }

    /** Returns the bodies {@code seconds} later; the result depends only on the arguments. */
    public Bodies step(Bodies before, PortalWorld surroundings, BodyInfluences influences, double seconds) {
        if (table.size() == 0) {
            return before;
        }
        int parts = (int) Math.max(1, Math.min(MOST_PARTS, Math.ceil(seconds / LONGEST_PART_SECONDS - 1e-6)));
        influences.begin();
        world = surroundings;
        around = influences;
        hasBegun = false;
        Bodies after = inParts(before, parts, MOST_BENT_PARTS, seconds);
        influences.end();
        return after;
    }

    /**
     * Moves the bodies in parts of equal length.
     *
     * @param again greatest number of parts into which each of them may be divided again
     */
    private Bodies inParts(Bodies before, int parts, int again, double seconds) {
        double part = seconds / parts;
        Bodies at = before;
        for (int i = 0; i < parts; i++) {
            load(at);
            boolean moves = begin(at, part);
            int finer = moves ? Math.min(again, finerParts(part)) : 1;
            if (finer > 1) {
                at = inParts(at, finer, again > PARTS_AGAIN ? PARTS_AGAIN : 1, part);
            } else if (moves) {
                at = end(at, part);
            } else {
                around.advance(part);
                at = hasBegun ? at : at.at(world.portals());
            }
            hasBegun = true;
        }
        return at;
    }

    private void load(Bodies before) {
        if (hasBegun) {
            bodies.loadPart(before);
        } else {
            bodies.load(before);
        }
    }

    private void countAwake() {
        awake = 0;
        for (int body = 0; body < bodies.count; body++) {
            awake += bodies.isAwake(body) ? 1 : 0;
        }
    }

    /** Returns the number of parts for which contacts must be found anew because bodies rotate too far in one. */
    private int finerParts(double seconds) {
        double most = 0;
        for (int body = 0; body < bodies.count; body++) {
            if (hasContactImpulse[body] && bodies.isAwake(body)) {
                most = Math.max(most, bendMetres(body, seconds));
            }
        }
        return bentParts(most, awake);
    }

    /** Finds and solves the contacts of a part; returns false when nothing moves. */
    private boolean begin(Bodies before, double seconds) {
        drive(around);
        place(around, seconds);
        search.activity().find(bodies, before.transforms(), world, gravity, seconds);
        wakeNeighbours(before.contacts());
        setMasses(around);
        search.activity().addImages(world, around, motions, seconds);
        search.index(before.contacts());
        if (search.wakeTouched(bodies, around, seconds)) {
            wakeNeighbours(before.contacts());
            setMasses(around);
        }
        countAwake();
        if (awake == 0 && !bodies.hasFrozen) {
            return false;
        }
        search.findContacts(bodies, world, around, seconds);
        solver.solve(bodies.count + around.characters(), awake, hasGravity, seconds);
        findPressed();
        return true;
    }

    /** Moves the bodies by the result of {@link #begin}. */
    private Bodies end(Bodies before, double seconds) {
        continuousMotion.begin(world, around, bodies, hasContactImpulse, motions, seconds);
        move(before);
        fallAsleep(seconds);
        giveImpulses(around);
        around.advance(seconds);
        ContactCache carried = search.remember(bodies);
        return new Bodies(bodies.motion, bodies.rest, carried, bodies.transforms(world.portals()));
    }

    /**
     * Returns the number of bodies in the last step that lost the rest of their tick after the greatest number of
     * portals.
     */
    public int cutShort() {
        return bodies.cutShort;
    }

    private void drive(BodyInfluences influences) {
        int count = table.size();
        if (driven.length < count) {
            driven = new boolean[count];
            hasContactImpulse = new boolean[count + 64];
        }
        Arrays.fill(driven, 0, count, false);
        for (int i = 0; i < influences.driven(); i++) {
            int body = influences.driven(i);
            driven[body] = bodies.rest[body] != Bodies.FROZEN;
            if (driven[body]) {
                bodies.rest[body] = 0;
                for (int k = 0; k < SolverState.STRIDE; k++) {
                    bodies.motion[Bodies.STRIDE * body + Bodies.VELOCITY + k] = influences.drive(i, k);
                }
            }
        }
    }

    private void place(BodyInfluences influences, double seconds) {
        poses.clear();
        int count = bodies.count;
        double fall = seconds * seconds / 2;
        for (int body = 0; body < count; body++) {
            poses.add(table.kind(body), body, -1);
            int at = Bodies.STRIDE * body;
            int q = at + Bodies.ORIENTATION;
            int v = at + Bodies.VELOCITY;
            double[] m = bodies.motion;
            poses.place(body, m[at], m[at + 1], m[at + 2]);
            poses.halves(body, table.half(body, 0), table.half(body, 1), table.half(body, 2));
            poses.turn(body, m[q], m[q + 1], m[q + 2], m[q + 3]);
            boolean awake = bodies.isAwake(body);
            poses.bound(
                    body,
                    awake ? m[v] * seconds + gravity.x() * fall : 0,
                    awake ? m[v + 1] * seconds + gravity.y() * fall : 0,
                    awake ? m[v + 2] * seconds + gravity.z() * fall : 0,
                    awake ? turnedMetres(body, seconds) : 0,
                    ContactSearch.REACH_METRES);
        }
        for (int i = 0; i < influences.characters(); i++) {
            BodyInfluences.Character c = influences.characterList().get(i);
            int shape = poses.add(BodyTable.CAPSULE, count + i, -1);
            poses.place(shape, c.centre.x, c.centre.y, c.centre.z);
            poses.halves(shape, 0, c.halfAxisMetres(), c.radiusMetres());
            poses.upright(shape);
            poses.bound(
                    shape,
                    c.velocity.x * seconds,
                    c.velocity.y * seconds,
                    c.velocity.z * seconds,
                    0,
                    ContactSearch.REACH_METRES);
        }
    }

    private double turnedMetres(int body, double seconds) {
        int w = Bodies.STRIDE * body + Bodies.SPIN;
        double[] m = bodies.motion;
        double spin = Math.sqrt(m[w] * m[w] + m[w + 1] * m[w + 1] + m[w + 2] * m[w + 2]);
        return spin * seconds * poses.radius(body);
    }

    private void setMasses(BodyInfluences influences) {
        int count = bodies.count;
        motions.resize(count + influences.characters() + 1);
        if (hasGravity.length < motions.count) {
            hasGravity = new boolean[motions.count + 64];
        }
        Arrays.fill(hasGravity, false);
        for (int body = 0; body < count; body++) {
            if (bodies.isAwake(body)) {
                motions.inverseMass[body] = table.inverseMass(body);
                hasGravity[body] = !driven[body];
                motions.turnInertia(
                        body,
                        poses.axes,
                        Poses.AXES * body,
                        table.inverseInertia(body, 0),
                        table.inverseInertia(body, 1),
                        table.inverseInertia(body, 2));
                System.arraycopy(
                        bodies.motion,
                        Bodies.STRIDE * body + Bodies.VELOCITY,
                        motions.velocity,
                        SolverState.STRIDE * body,
                        SolverState.STRIDE);
            }
        }
        for (int i = 0; i < influences.characters(); i++) {
            BodyInfluences.Character c = influences.characterList().get(i);
            motions.keepUpright(count + i);
            motions.inverseMass[count + i] = 1 / c.massKilograms;
            int v = SolverState.STRIDE * (count + i);
            motions.velocity[v] = c.velocity.x;
            motions.velocity[v + 1] = c.velocity.y;
            motions.velocity[v + 2] = c.velocity.z;
        }
    }

    private void findPressed() {
        Arrays.fill(hasContactImpulse, 0, bodies.count, false);
        for (int m = 0; m < rows.count; m++) {
            if (rows.carries(m)) {
                mark(rows.slotA[m]);
                mark(rows.slotB[m]);
            }
        }
    }

    private void move(Bodies before) {
        for (int body = 0; body < bodies.count; body++) {
            if (!bodies.isAwake(body)) {
                continue;
            }
            if (hasContactImpulse[body]) {
                continuousMotion.advanceSolved(body, motions, !driven[body]);
            } else {
                continuousMotion.advanceFree(body, !driven[body]);
            }
            if (!bodies.isFinite(body)) {
                bodies.freeze(body, before);
            }
        }
    }

    private void mark(int slot) {
        if (slot < bodies.count) {
            hasContactImpulse[slot] = true;
        }
    }

    private void giveImpulses(BodyInfluences influences) {
        for (int i = 0; i < influences.characters(); i++) {
            int v = SolverState.STRIDE * (bodies.count + i);
            double[] m = motions.velocity;
            influences.characterList().get(i).give(m[v], m[v + 1], m[v + 2]);
        }
    }

    /** Returns the number of parts of a step with this greatest deviation. */
    private static int bentParts(double bendMetres, int awake) {
        double wanted = Math.ceil(Math.sqrt(bendMetres / BEND_METRES));
        return (int) Math.max(1, Math.min(wanted, Math.min(MOST_BENT_PARTS, MOST_BODY_STEPS / Math.max(1, awake))));
    }

    /** Returns the greatest deviation of a body's points from a straight path by its rotation: r ω² t² / 2. */
    private double bendMetres(int body, double seconds) {
        if (poses.kind[body] == BodyTable.SPHERE) {
            return 0;
        }
        double spin = findAxisSpeeds(body);
        if (spin * seconds < LEAST_RADIANS) {
            return 0;
        }
        // Rotation of a capsule about its axis does not move its surface.
        boolean box = poses.kind[body] == BodyTable.BOX;
        double hX = box ? poses.half[3 * body] : 0;
        double hY = poses.half[3 * body + 1];
        double hZ = box ? poses.half[3 * body + 2] : 0;
        double sX = axisSpeeds[1] * hZ + axisSpeeds[2] * hY;
        double sY = axisSpeeds[2] * hX + axisSpeeds[0] * hZ;
        double sZ = axisSpeeds[0] * hY + axisSpeeds[1] * hX;
        double speed = Math.sqrt(sX * sX + sY * sY + sZ * sZ);
        return Math.min(spin * speed * seconds * seconds / 2, 2 * speed / spin);
    }

    /** Writes the speeds of rotation about each of the body's axes; returns the whole speed of rotation. */
    private double findAxisSpeeds(int body) {
        int w = SolverState.STRIDE * body + SolverState.ANGULAR;
        double[] v = motions.velocity;
        double[] x = poses.axes;
        double square = 0;
        for (int i = 0; i < 3; i++) {
            int at = Poses.AXES * body + 3 * i;
            axisSpeeds[i] = Math.abs(v[w] * x[at] + v[w + 1] * x[at + 1] + v[w + 2] * x[at + 2]);
            square += axisSpeeds[i] * axisSpeeds[i];
        }
        return Math.sqrt(square);
    }

    /** Wakes the bodies that were in contact with an awake one, directly or through others. */
    private void wakeNeighbours(ContactCache memory) {
        boolean anyAsleep = false;
        for (int body = 0; body < bodies.count; body++) {
            anyAsleep |= bodies.rest[body] == Bodies.ASLEEP;
        }
        if (!anyAsleep) {
            return;
        }
        if (pressed.length < bodies.count) {
            pressed = new boolean[bodies.count];
        }
        islands.reset(bodies.count);
        for (int i = 0; i < memory.size(); i++) {
            int a = ContactCache.first(memory.key(i));
            int b = ContactCache.second(memory.key(i));
            if (a < bodies.count && b >= 0 && b < bodies.count) {
                islands.join(a, b);
            }
        }
        Arrays.fill(pressed, 0, bodies.count, false);
        for (int body = 0; body < bodies.count; body++) {
            pressed[islands.root(body)] |= bodies.isAwake(body);
        }
        for (int body = 0; body < bodies.count; body++) {
            if (pressed[islands.root(body)]) {
                bodies.wake(body);
            }
        }
    }

    /** Counts each body's time at rest, and puts islands to sleep that have rested long enough. */
    private void fallAsleep(double seconds) {
        islands.reset(bodies.count);
        for (int m = 0; m < rows.count; m++) {
            if (rows.slotA[m] < bodies.count && rows.slotB[m] < bodies.count && rows.carries(m)) {
                islands.join(rows.slotA[m], rows.slotB[m]);
            }
        }
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body)) {
                boolean resting = hasContactImpulse[body] && !driven[body] && isSlow(body);
                bodies.rest[body] = resting ? Math.min(1, bodies.rest[body] + (float) seconds) : 0;
            }
        }
        if (islandRest.length < bodies.count) {
            islandRest = new float[bodies.count];
        }
        islands.least(bodies.rest, bodies.count, islandRest);
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body) && islandRest[islands.root(body)] >= SLEEP_SECONDS) {
                bodies.halt(body);
                bodies.rest[body] = Bodies.ASLEEP;
            }
        }
    }

    private boolean isSlow(int body) {
        double[] m = bodies.motion;
        int v = Bodies.STRIDE * body + Bodies.VELOCITY;
        int w = Bodies.STRIDE * body + Bodies.SPIN;
        double radius = poses.radius(body);
        double square = m[v] * m[v] + m[v + 1] * m[v + 1] + m[v + 2] * m[v + 2];
        square += radius * radius * (m[w] * m[w] + m[w + 1] * m[w + 1] + m[w + 2] * m[w + 2]);
        return square < REST_METRES_PER_SECOND * REST_METRES_PER_SECOND;
    }
}
