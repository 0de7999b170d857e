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

    /** Masses that touch and differ by less than this factor are even. */
    private static final double EVEN_MASSES = Double.parseDouble(System.getProperty("masses", "2"));

    /** Edges of a body that differ by less than this factor are even. */
    private static final double EVEN_EDGES = Double.parseDouble(System.getProperty("edges", "4"));

    /** Longer ticks are stepped in parts: where shapes touch is found once a part. */
    private static final double LONGEST_PART_SECONDS = 1 / 120.0;

    private static final int MOST_PARTS = 32;

    /** Where the way of a point of a body that touches something bends by more, contacts are found anew in between. */
    private static final double BEND_METRES = Double.parseDouble(System.getProperty("bend", "3e-5"));

    private static final int MOST_FINER_PARTS = 16;
    /** Finer parts are for few bodies: this many steps of a body in all. */
    private static final int MOST_BODIES_A_TICK = 64;

    /** Products of blocks a body that the direct solver may spend on an island. */
    private static final double MOST_PRODUCTS_A_BODY = Double.parseDouble(System.getProperty("most", "12"));

    /** So long a group rests before it sleeps. */
    private static final float SLEEP_SECONDS = 0.5f;

    private static final double REST_METRES_PER_SECOND = 0.03;

    private final BodyTable table;
    private final Vec3 gravity;
    private final TickBodies bodies = new TickBodies();
    private final Poses poses = new Poses();
    private final Motions motions = new Motions();
    private final ContactRows rows = new ContactRows(motions);
    private final IslandSolver exact = new IslandSolver(rows, motions);
    private final ContactSolver solver = new ContactSolver(motions, rows);
    private final ContactSearch search;
    private final Flight flight;
    private final Islands islands = new Islands();
    private float[] islandRest = new float[0];
    private boolean[] pressed = new boolean[0];
    private boolean[] held = new boolean[0];
    /** Per slot: whether gravity pulls at it. */
    private boolean[] weighs = new boolean[0];
    /** Per slot: whether the solver in substeps moves it. */
    private boolean[] stepped = new boolean[0];
    /** Manifolds, island by island. */
    private int[] order = new int[0];

    private int grouped;
    private int[] next = new int[0];
    private int[] firstOf = new int[0];
    /** Manifolds that are left to the solver in substeps. */
    private int[] rest = new int[0];

    /** @param gravity m/s² */
    public RigidStep(BodyTable table, Vec3 gravity) {
        this.table = table;
        this.gravity = gravity;
        search = new ContactSearch(table, poses, motions, rows);
        flight = new Flight(table, gravity, search, poses);
    }

    /** The bodies {@code seconds} later: all that the tick depends on is in the arguments. */
    public Bodies step(Bodies before, Surroundings surroundings, Influences influences, double seconds) {
        if (table.size() == 0) {
            return before;
        }
        int parts = (int) Math.max(1, Math.min(MOST_PARTS, Math.ceil(seconds / LONGEST_PART_SECONDS - 1e-6)));
        double part = seconds / parts;
        influences.begin();
        Bodies after = inParts(before, surroundings, influences, new Cut(parts, false), seconds);
        influences.end();
        return after;
    }

    /** How a span of time is cut: into equal parts, and whether these belong to a tick that has begun. */
    private record Cut(int parts, boolean isLater) {}

    private Bodies inParts(Bodies before, Surroundings surroundings, Influences influences, Cut cut, double seconds) {
        double part = seconds / cut.parts;
        Bodies at = before;
        for (int i = 0; i < cut.parts; i++) {
            boolean later = cut.isLater || i > 0;
            load(at, later);
            boolean stepped = begin(at, surroundings, influences, part);
            int finer = stepped ? finerParts(part) : 1;
            if (finer > 1) {
                at = inFinerParts(at, surroundings, influences, new Cut(finer, later), part);
            } else {
                at = end(at, surroundings, influences, stepped, later, part);
            }
        }
        return at;
    }

    private Bodies inFinerParts(
            Bodies before, Surroundings surroundings, Influences influences, Cut cut, double seconds) {
        double part = seconds / cut.parts;
        Bodies at = before;
        for (int i = 0; i < cut.parts; i++) {
            boolean later = cut.isLater || i > 0;
            load(at, later);
            boolean stepped = begin(at, surroundings, influences, part);
            at = end(at, surroundings, influences, stepped, later, part);
        }
        return at;
    }

    private void load(Bodies before, boolean later) {
        if (later) {
            bodies.loadPart(before);
        } else {
            bodies.load(before);
        }
    }

    /** Into how many parts contacts have to be found anew because bodies turn too far in one. */
    private int finerParts(double seconds) {
        int awake = 0;
        double most = 0;
        findPressed();
        for (int body = 0; body < bodies.count; body++) {
            awake += bodies.isAwake(body) ? 1 : 0;
            if (pressed[body] && bodies.isAwake(body)) {
                most = Math.max(most, bendMetres(body, seconds));
            }
        }
        double wanted = Math.ceil(Math.sqrt(most / BEND_METRES));
        return (int) Math.max(1, Math.min(wanted, Math.min(MOST_FINER_PARTS, MOST_BODIES_A_TICK / Math.max(1, awake))));
    }

    /** How far, at most, the way of a point of a body bends off a straight line by the body's turn: r ω² t² / 2. */
    private double bendMetres(int body, double seconds) {
        if (poses.kind[body] == BodyTable.SPHERE) {
            return 0;
        }
        int w = 6 * body + 3;
        double[] v = motions.velocity;
        double[] x = poses.axes;
        double[] local = new double[3];
        for (int i = 0; i < 3; i++) {
            int at = 9 * body + 3 * i;
            local[i] = Math.abs(v[w] * x[at] + v[w + 1] * x[at + 1] + v[w + 2] * x[at + 2]);
        }
        double spin = Math.sqrt(local[0] * local[0] + local[1] * local[1] + local[2] * local[2]);
        if (spin * seconds < 1e-3) {
            return 0;
        }
        boolean box = poses.kind[body] == BodyTable.BOX;
        double hX = box ? poses.half[3 * body] : 0;
        double hY = poses.half[3 * body + 1];
        double hZ = box ? poses.half[3 * body + 2] : 0;
        double sX = local[1] * hZ + local[2] * hY;
        double sY = local[2] * hX + local[0] * hZ;
        double sZ = local[0] * hY + local[1] * hX;
        double speed = Math.sqrt(sX * sX + sY * sY + sZ * sZ);
        return Math.min(spin * speed * seconds * seconds / 2, 2 * speed / spin);
    }

    /** Finds and solves the contacts of a part; false when nothing moves. */
    private boolean begin(Bodies before, Surroundings surroundings, Influences influences, double seconds) {
        drive(influences);
        place(influences, seconds);
        search.activity().find(bodies, before.passages(), surroundings, gravity, seconds);
        wakeNeighbours(before.contacts());
        setMasses(influences);
        search.activity().addImages(surroundings, influences, motions, seconds);
        search.index(before.contacts(), seconds);
        if (search.wakeTouched(bodies, influences, seconds)) {
            wakeNeighbours(before.contacts());
            setMasses(influences);
        }
        if (isAllAsleep() && !bodies.hasFrozen) {
            return false;
        }
        search.findContacts(bodies, surroundings, influences, seconds);
        solve(influences, seconds);
        return true;
    }

    /** Moves the bodies by what {@link #begin} has found. */
    private Bodies end(
            Bodies before,
            Surroundings surroundings,
            Influences influences,
            boolean stepped,
            boolean later,
            double seconds) {
        if (!stepped) {
            influences.advance(seconds);
            return later ? before : before.at(surroundings.portals());
        }
        flight.begin(surroundings, influences, bodies, seconds);
        move(before);
        fallAsleep(seconds);
        giveImpulses(influences);
        influences.advance(seconds);
        ContactMemory carried = search.remember(before.contacts(), bodies, seconds);
        return new Bodies(bodies.motion, bodies.rest, carried, bodies.passages(surroundings.portals()));
    }

    /** In the last step: how often the rest of a tick was dropped after as many portals as a tick may have. */
    public int cutShort() {
        return bodies.cutShort;
    }

    private void drive(Influences influences) {
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
        if (weighs.length < motions.count) {
            weighs = new boolean[motions.count + 64];
        }
        Arrays.fill(weighs, false);
        for (int body = 0; body < count; body++) {
            if (bodies.isAwake(body)) {
                motions.inverseMass[body] = table.inverseMass(body);
                weighs[body] = !held[body];
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
            motions.keepUpright(count + i);
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
        rows.rememberApproach();
        int slots = bodies.count + influences.characters();
        group(slots);
        Arrays.fill(stepped, 0, slots, false);
        int left = 0;
        for (int i = 0; i < grouped; ) {
            int end = islandEnd(i);
            if (needsExact(i, end) && exact.take(order, i, end, MOST_PRODUCTS_A_BODY)) {
                exact.solve(gravity, weighs, seconds);
            } else {
                for (int k = i; k < end; k++) {
                    stepped[rows.slotA[order[k]]] = true;
                    stepped[rows.slotB[order[k]]] = true;
                    rest[left++] = order[k];
                }
            }
            i = end;
        }
        if (left > 0) {
            solveInSubsteps(left, slots, seconds);
        }
        solver.bounce();
    }

    private int root(int m) {
        int a = rows.slotA[m];
        return islands.root(motions.inverseMass[a] > 0 ? a : rows.slotB[m]);
    }

    /** Whether an island has what sequential impulses are slow or wrong about: unequal masses, or thin bodies. */
    private boolean needsExact(int from, int to) {
        boolean alone = true;
        boolean hard = false;
        for (int i = from; i < to && !hard; i++) {
            int a = rows.slotA[order[i]];
            int b = rows.slotB[order[i]];
            double ia = motions.inverseMass[a];
            double ib = motions.inverseMass[b];
            alone &= ia == 0 || ib == 0;
            hard = isThin(a) || isThin(b) || ia > 0 && ib > 0 && Math.max(ia, ib) > EVEN_MASSES * Math.min(ia, ib);
        }
        return hard || alone;
    }

    private boolean isThin(int slot) {
        return slot < bodies.count && table.slenderness(slot) > EVEN_EDGES;
    }

    private int islandEnd(int from) {
        int root = root(order[from]);
        int end = from + 1;
        while (end < grouped && root(order[end]) == root) {
            end++;
        }
        return end;
    }

    /** Sorts the manifolds by island; within one they stay in order. */
    private void group(int slots) {
        islands.reset(slots);
        for (int m = 0; m < rows.count; m++) {
            int a = rows.slotA[m];
            int b = rows.slotB[m];
            if (a < slots && b < slots && motions.inverseMass[a] > 0 && motions.inverseMass[b] > 0) {
                islands.join(a, b);
            }
        }
        if (order.length < rows.count) {
            order = new int[2 * rows.count];
            rest = new int[2 * rows.count];
            next = new int[2 * rows.count];
        }
        if (firstOf.length <= slots) {
            firstOf = new int[slots + 64];
            stepped = new boolean[slots + 64];
        }
        Arrays.fill(firstOf, 0, slots, -1);
        for (int m = rows.count - 1; m >= 0; m--) {
            int r = root(m);
            next[m] = firstOf[r];
            firstOf[r] = m;
        }
        grouped = 0;
        for (int slot = 0; slot < slots; slot++) {
            for (int m = firstOf[slot]; m >= 0; m = next[m]) {
                order[grouped++] = m;
            }
        }
    }

    private void solveInSubsteps(int count, int slots, double seconds) {
        int substeps = (int) Math.max(2, Math.min(MOST_SUBSTEPS, Math.round(seconds * SUBSTEPS_A_SECOND)));
        double h = seconds / substeps;
        for (int i = 0; i < count; i++) {
            rows.scaleImpulses(rest[i], 1.0 / substeps);
        }
        solver.begin(rest, count);
        for (int i = 0; i < substeps; i++) {
            weigh(h);
            solver.warmStart();
            solver.solve(h, true);
            advance(h, slots);
            solver.relax(h);
        }
        for (int i = 0; i < count; i++) {
            rows.scaleImpulses(rest[i], substeps);
        }
    }

    private void weigh(double h) {
        for (int body = 0; body < bodies.count; body++) {
            if (stepped[body] && weighs[body]) {
                motions.velocity[6 * body] += gravity.x() * h;
                motions.velocity[6 * body + 1] += gravity.y() * h;
                motions.velocity[6 * body + 2] += gravity.z() * h;
            }
        }
    }

    private void advance(double h, int slots) {
        for (int slot = 0; slot < slots; slot++) {
            for (int i = 6 * slot; stepped[slot] && i < 6 * slot + 6; i++) {
                motions.moved[i] += h * motions.velocity[i];
            }
        }
    }

    private void findPressed() {
        Arrays.fill(pressed, 0, bodies.count, false);
        for (int m = 0; m < rows.count; m++) {
            if (rows.carries(m)) {
                mark(rows.slotA[m]);
                mark(rows.slotB[m]);
            }
        }
    }

    private void move(Bodies before) {
        findPressed();
        flight.expect(bodies, pressed, motions);
        for (int body = 0; body < bodies.count; body++) {
            if (!bodies.isAwake(body)) {
                continue;
            }
            if (pressed[body]) {
                flight.follow(bodies, body, motions, !held[body]);
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
            int v = 6 * (bodies.count + i);
            double[] m = motions.velocity;
            influences.characterList().get(i).give(m[v], m[v + 1], m[v + 2]);
        }
    }
}
