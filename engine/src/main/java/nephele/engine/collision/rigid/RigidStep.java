package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.math.Vec3;

/**
 * Moves bodies by one tick: finds contacts, solves them in substeps, lets what touches nothing fly exactly, and puts to
 * sleep what has come to rest. Not for two threads at once: the working set is reused.
 */
public final class RigidStep {
    /** As near as whole numbers of them come to a tick: four at 120 ticks a second. */
    private static final double SUBSTEPS_A_SECOND = 480;

    private static final int MOST_SUBSTEPS = 32;

    /** So long a group rests before it sleeps. */
    private static final float SLEEP_SECONDS = 0.5f;

    private static final double REST_METRES_PER_SECOND = 0.03;

    private final BodyTable table;
    private final Vec3 gravity;
    private final TickBodies bodies = new TickBodies();
    private final Poses poses = new Poses();
    private final Motions motions = new Motions();
    private final ContactRows rows = new ContactRows(motions);
    private final ContactSolver solver = new ContactSolver(motions, rows);
    private final ContactSearch search;
    private final Flight flight;
    private final Islands islands = new Islands();
    private float[] islandRest = new float[0];
    private boolean[] pressed = new boolean[0];
    private boolean[] held = new boolean[0];

    /** @param gravity m/s² */
    public RigidStep(BodyTable table, Vec3 gravity) {
        this.table = table;
        this.gravity = gravity;
        search = new ContactSearch(table, poses, motions, rows);
        flight = new Flight(table, gravity, search.narrow(), poses);
    }

    /** The bodies {@code seconds} later: all that the tick depends on is in the arguments. */
    public Bodies step(Bodies before, Surroundings surroundings, Influences influences, double seconds) {
        if (table.size() == 0) {
            return before;
        }
        load(before, influences);
        place(influences, seconds);
        search.activity().find(bodies, before.passages(), surroundings, gravity, seconds);
        wakeNeighbours(before.contacts());
        setMasses(influences);
        search.activity().addImages(surroundings, influences, motions, seconds);
        search.index(before.contacts());
        if (search.wakeTouched(bodies, influences, seconds)) {
            wakeNeighbours(before.contacts());
            setMasses(influences);
        }
        if (isAllAsleep() && !bodies.hasFrozen) {
            return before.at(surroundings.portals());
        }
        search.findContacts(bodies, surroundings, influences, seconds);
        solve(influences, seconds);
        flight.begin(surroundings, influences, bodies, seconds);
        move(before);
        fallAsleep(seconds);
        giveImpulses(influences);
        ContactMemory carried = search.remember(before.contacts(), bodies);
        return new Bodies(bodies.motion, bodies.rest, carried, bodies.passages(surroundings.portals()));
    }

    /** In the last step: how often the rest of a tick was dropped after as many portals as a tick may have. */
    public int cutShort() {
        return bodies.cutShort;
    }

    private void load(Bodies before, Influences influences) {
        bodies.load(before);
        int count = table.size();
        if (held.length < count) {
            held = new boolean[count];
            pressed = new boolean[count + 64];
            islandRest = new float[count];
        }
        Arrays.fill(held, 0, count, false);
        for (int i = 0; i < influences.driven(); i++) {
            int body = influences.driven(i);
            held[body] = bodies.rest[body] != Bodies.FROZEN;
            if (held[body]) {
                bodies.rest[body] = 0;
                for (int k = 0; k < 6; k++) {
                    bodies.motion[Bodies.STRIDE * body + Bodies.VELOCITY + k] = influences.drive(i, k);
                }
            }
        }
    }

    /** Whoever leant on somebody who is awake wakes, and all who lean on them. */
    private void wakeNeighbours(ContactMemory memory) {
        boolean anyAsleep = false;
        for (int body = 0; body < bodies.count; body++) {
            anyAsleep |= bodies.rest[body] == Bodies.ASLEEP;
        }
        if (!anyAsleep) {
            return;
        }
        islands.reset(bodies.count);
        for (int i = 0; i < memory.size(); i++) {
            int a = ContactKey.first(memory.key(i));
            int b = ContactKey.second(memory.key(i));
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

    private boolean isAllAsleep() {
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body)) {
                return false;
            }
        }
        return true;
    }

    private void place(Influences influences, double seconds) {
        poses.clear();
        int count = bodies.count;
        double fall = seconds * seconds / 2;
        for (int body = 0; body < count; body++) {
            poses.add(table.kind(body), body, -1);
            int at = Bodies.STRIDE * body;
            double[] m = bodies.motion;
            poses.place(body, m[at], m[at + 1], m[at + 2]);
            poses.halves(body, table.half(body, 0), table.half(body, 1), table.half(body, 2));
            poses.turn(body, m[at + 3], m[at + 4], m[at + 5], m[at + 6]);
            boolean awake = bodies.isAwake(body);
            poses.bound(
                    body,
                    awake ? m[at + 7] * seconds + gravity.x() * fall : 0,
                    awake ? m[at + 8] * seconds + gravity.y() * fall : 0,
                    awake ? m[at + 9] * seconds + gravity.z() * fall : 0,
                    ContactSearch.REACH_METRES);
        }
        for (int i = 0; i < influences.characters(); i++) {
            Influences.Character c = influences.characterList().get(i);
            int shape = poses.add(BodyTable.CAPSULE, count + i, -1);
            poses.place(shape, c.centre.x, c.centre.y, c.centre.z);
            poses.halves(shape, 0, c.halfAxisMetres(), c.radiusMetres());
            poses.upright(shape);
            poses.bound(
                    shape,
                    c.velocity.x * seconds,
                    c.velocity.y * seconds,
                    c.velocity.z * seconds,
                    ContactSearch.REACH_METRES);
        }
    }

    private void setMasses(Influences influences) {
        int count = bodies.count;
        motions.resize(count + influences.characters() + 1);
        for (int body = 0; body < count; body++) {
            if (bodies.isAwake(body)) {
                motions.inverseMass[body] = table.inverseMass(body);
                motions.turnInertia(
                        body,
                        poses.axes,
                        9 * body,
                        table.inverseInertia(body, 0),
                        table.inverseInertia(body, 1),
                        table.inverseInertia(body, 2));
                System.arraycopy(bodies.motion, Bodies.STRIDE * body + Bodies.VELOCITY, motions.velocity, 6 * body, 6);
            }
        }
        for (int i = 0; i < influences.characters(); i++) {
            Influences.Character c = influences.characterList().get(i);
            motions.inverseMass[count + i] = 1 / c.massKilograms;
            motions.velocity[6 * (count + i)] = c.velocity.x;
            motions.velocity[6 * (count + i) + 1] = c.velocity.y;
            motions.velocity[6 * (count + i) + 2] = c.velocity.z;
        }
    }

    private void solve(Influences influences, double seconds) {
        if (rows.count == 0) {
            return;
        }
        int substeps = (int) Math.max(2, Math.min(MOST_SUBSTEPS, Math.round(seconds * SUBSTEPS_A_SECOND)));
        double h = seconds / substeps;
        solver.begin();
        for (int i = 0; i < substeps; i++) {
            weigh(h);
            solver.warmStart();
            solver.solve(h, true);
            advance(h, influences.characters());
            solver.relax(h);
        }
        solver.bounce();
    }

    private void weigh(double h) {
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body) && !held[body]) {
                motions.velocity[6 * body] += gravity.x() * h;
                motions.velocity[6 * body + 1] += gravity.y() * h;
                motions.velocity[6 * body + 2] += gravity.z() * h;
            }
        }
    }

    private void advance(double h, int characters) {
        for (int i = 0; i < 6 * (bodies.count + characters); i++) {
            motions.moved[i] += h * motions.velocity[i];
        }
    }

    private void move(Bodies before) {
        Arrays.fill(pressed, 0, bodies.count, false);
        for (int m = 0; m < rows.count; m++) {
            if (rows.carries(m)) {
                mark(rows.slotA[m]);
                mark(rows.slotB[m]);
            }
        }
        flight.expect(bodies, pressed, motions);
        for (int body = 0; body < bodies.count; body++) {
            if (!bodies.isAwake(body)) {
                continue;
            }
            if (pressed[body]) {
                flight.follow(bodies, body, motions);
            } else {
                flight.fly(bodies, body, !held[body]);
            }
            if (!bodies.isFinite(body)) {
                bodies.freeze(body, before);
            }
        }
    }

    private void mark(int slot) {
        if (slot < bodies.count) {
            pressed[slot] = true;
        }
    }

    private void fallAsleep(double seconds) {
        islands.reset(bodies.count);
        for (int m = 0; m < rows.count; m++) {
            if (rows.slotA[m] < bodies.count && rows.slotB[m] < bodies.count && rows.carries(m)) {
                islands.join(rows.slotA[m], rows.slotB[m]);
            }
        }
        for (int body = 0; body < bodies.count; body++) {
            if (bodies.isAwake(body)) {
                boolean resting = pressed[body] && !held[body] && isSlow(body);
                bodies.rest[body] = resting ? Math.min(1, bodies.rest[body] + (float) seconds) : 0;
            }
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

    private void giveImpulses(Influences influences) {
        for (int i = 0; i < influences.characters(); i++) {
            Influences.Character c = influences.characterList().get(i);
            int v = 6 * (bodies.count + i);
            c.impulse
                    .set(motions.velocity[v], motions.velocity[v + 1], motions.velocity[v + 2])
                    .sub(c.velocity)
                    .mul(c.massKilograms);
        }
    }
}
