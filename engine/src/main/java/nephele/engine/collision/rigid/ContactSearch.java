package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.ContactCache;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.contact.Manifold;
import nephele.engine.collision.rigid.contact.NarrowPhase;
import nephele.engine.collision.rigid.solver.ContactRows;
import nephele.engine.collision.rigid.solver.SolverState;
import nephele.engine.math.bvh.ItemList;

/** Finds the contacts of a tick, makes the solver's rows and stores their impulses in the contact cache. Reused. */
final class ContactSearch {
    /** Distance of surfaces below which contacts are sought even without motion; less for thin bodies. */
    static final double REACH_METRES = 0.01;

    /**
     * Greatest distance at which contacts are made ahead of motion; continuous collision detection stops faster bodies.
     */
    private static final double FAR_METRES = 0.1;

    /**
     * Margin within which an approaching shape wakes a sleeping body: more than gravity adds to a displacement in 1/120
     * s.
     */
    private static final double WAKING_METRES = 1e-3;

    private static final double SLOP_METRES = 5e-4;
    /** Walking feet exert no force along the ground on average, and a character pushes without friction. */
    private static final double CHARACTER_FRICTION_COEFFICIENT = 0;

    private static final int NO_ENTRY = -1;

    private final BodyTable table;
    private final Poses poses;
    private final SolverState motions;
    private final ContactRows rows;
    private final NarrowPhase narrow;
    /** The shapes in their order along an axis, and their least bounds there. */
    private int[] order = new int[0];

    private double[] from = new double[0];
    private final ItemList pairs = new ItemList();
    /** The contacts of the step before, and their entries by their shapes in a hash table with linear probing. */
    private ContactCache last = ContactCache.NONE;

    private int[] entries = new int[16];
    private int mask = 15;
    private final Manifold manifold = new Manifold();
    private final ItemList near = new ItemList();
    private final double[] offset = new double[3];
    private final double[] turn = new double[9];
    private final double[] relative = new double[3];
    private final PortalContacts portalContacts;

    private TickBodies bodies;
    private BodyInfluences influences;
    private double seconds;
    private boolean woke;
    /** First manifold of each body with solids; the last body's end where those of pairs begin. */
    private int[] firstWithSolid = new int[1];

    ContactSearch(BodyTable table, Poses poses, SolverState motions, ContactRows rows) {
        this.table = table;
        this.poses = poses;
        this.motions = motions;
        this.rows = rows;
        narrow = new NarrowPhase(table, poses);
        portalContacts = new PortalContacts(poses, narrow);
    }

    PortalContacts activity() {
        return portalContacts;
    }

    NarrowPhase narrow() {
        return narrow;
    }

    /** Sets the contacts of the step before, which warm start those of this one. */
    void index(ContactCache contacts) {
        last = contacts;
        int size = Integer.highestOneBit(Math.max(8, last.size())) * 4;
        if (entries.length < size) {
            entries = new int[size];
        }
        mask = size - 1;
        Arrays.fill(entries, 0, size, NO_ENTRY);
        for (int i = 0; i < last.size(); i++) {
            int at = slot(ContactCache.parties(last.key(i)));
            while (entries[at] != NO_ENTRY) {
                at = at + 1 & mask;
            }
            entries[at] = i;
        }
    }

    private int slot(long parties) {
        long mixed = parties * 0x9e3779b97f4a7c15L;
        return (int) (mixed >>> 32) & mask;
    }

    /** Returns the entry of the step before with the shapes and touching features of a key, {@link #NO_ENTRY} for none. */
    private int entry(long key) {
        long parties = ContactCache.parties(key);
        int at = slot(parties);
        while (entries[at] != NO_ENTRY && ContactCache.parties(last.key(entries[at])) != parties) {
            at = at + 1 & mask;
        }
        int found = entries[at];
        return found != NO_ENTRY && ContactCache.isSameFeatures(last.key(found), key) ? found : NO_ENTRY;
    }

    /** Wakes the sleeping bodies that a moving shape is about to touch; returns true if any was woken. */
    boolean wakeTouched(TickBodies now, BodyInfluences from, double tickSeconds) {
        begin(now, from, tickSeconds);
        woke = false;
        boolean anyAsleep = false;
        for (int body = 0; body < bodies.count; body++) {
            anyAsleep |= bodies.rest[body] == Bodies.ASLEEP;
        }
        if (anyAsleep) {
            findPairs();
            for (int i = 0; i < pairs.size(); i += 2) {
                wakePair(pairs.get(i), pairs.get(i + 1));
            }
        }
        return woke;
    }

    private void begin(TickBodies now, BodyInfluences from, double tickSeconds) {
        bodies = now;
        influences = from;
        seconds = tickSeconds;
    }

    private void wakePair(int a, int b) {
        int sleeper = isAsleep(a) ? a : isAsleep(b) ? b : -1;
        if (sleeper < 0 || !moves(sleeper == a ? b : a) || !canMeet(a, b)) {
            return;
        }
        meet(a, b);
        boolean isTouched = poses.through[b] >= 0 ? manifold.count > 0 : reaches(a, b, sleeper);
        if (isTouched) {
            bodies.wake(poses.owner[sleeper]);
            woke = true;
        }
    }

    /**
     * Returns true if the moving shape reaches the sleeper within the tick. Distance alone would not do: a capsule that
     * rolls past is near all the time.
     */
    private boolean reaches(int a, int b, int sleeper) {
        double[] m = motions.velocity;
        int v = SolverState.STRIDE * poses.owner[sleeper == a ? b : a];
        int w = v + SolverState.ANGULAR;
        double towards = sleeper == a ? seconds : -seconds;
        for (int i = 0; i < manifold.count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double fromMover = sleeper == a ? poses.centre[3 * b + axis] - poses.centre[3 * a + axis] : 0;
                relative[axis] = manifold.point[3 * i + axis] - fromMover;
            }
            double x = m[v] + m[w + 1] * relative[2] - m[w + 2] * relative[1];
            double y = m[v + 1] + m[w + 2] * relative[0] - m[w] * relative[2];
            double z = m[v + 2] + m[w] * relative[1] - m[w + 1] * relative[0];
            double path = towards * (manifold.nX * x + manifold.nY * y + manifold.nZ * z);
            if (manifold.separation[i] <= path + WAKING_METRES) {
                return true;
            }
        }
        return false;
    }

    private void meet(int a, int b) {
        narrow.touch(a, b, reach(a, b), influences.characterList(), manifold);
        portalContacts.keepValid(manifold, a, b);
    }

    private boolean isAsleep(int shape) {
        int owner = poses.owner[shape];
        return owner < bodies.count && bodies.rest[owner] == Bodies.ASLEEP;
    }

    private boolean moves(int shape) {
        int owner = poses.owner[shape];
        if (owner < bodies.count) {
            // A body that rests beside a sleeper without contact force must not wake it, or both would wake each other
            // for ever.
            return bodies.isAwake(owner) && bodies.rest[owner] == 0;
        }
        return influences.characterList().get(owner - bodies.count).velocity.lengthSquared() > 1e-4;
    }

    private boolean canMeet(int a, int b) {
        int ownerA = poses.owner[a];
        int ownerB = poses.owner[b];
        boolean bodyA = ownerA < bodies.count;
        boolean bodyB = ownerB < bodies.count;
        boolean apart = bodyA != bodyB && !influences.meetsCharacters(bodyA ? ownerA : ownerB);
        return !apart && portalContacts.isPair(a, b);
    }

    /** Returns the distance below which surfaces matter in this tick. */
    private double reach(int a, int b) {
        int u = SolverState.STRIDE * poses.owner[a];
        int v = SolverState.STRIDE * poses.owner[b];
        double[] m = motions.velocity;
        System.arraycopy(m, v, relative, 0, 3);
        if (poses.through[b] >= 0) {
            portalContacts.turn(poses.through[b], turn);
            for (int i = 0; i < 3; i++) {
                relative[i] = turn[i] * m[v] + turn[3 + i] * m[v + 1] + turn[6 + i] * m[v + 2];
            }
        }
        double x = m[u] - relative[0];
        double y = m[u + 1] - relative[1];
        double z = m[u + 2] - relative[2];
        double path = seconds * (Math.sqrt(x * x + y * y + z * z) + turning(a) + turning(b));
        double least = Math.min(poses.leastHalf(a), poses.leastHalf(b));
        return reach(least, path);
    }

    private static double reach(double leastHalf, double path) {
        return Math.min(REACH_METRES, leastHalf / 2) / 2 + Math.min(path, Math.max(leastHalf / 2, FAR_METRES));
    }

    private double reach(int body) {
        double[] m = motions.velocity;
        int u = SolverState.STRIDE * body;
        double path = seconds * (Math.sqrt(m[u] * m[u] + m[u + 1] * m[u + 1] + m[u + 2] * m[u + 2]) + turning(body));
        return reach(poses.leastHalf(body), path);
    }

    private double turning(int shape) {
        double[] m = motions.velocity;
        int w = SolverState.STRIDE * poses.owner[shape] + SolverState.ANGULAR;
        double square = m[w] * m[w] + m[w + 1] * m[w + 1] + m[w + 2] * m[w + 2];
        return square < 1e-12 ? 0 : Math.sqrt(square) * poses.radius(shape);
    }

    /**
     * Makes rows for every contact of an awake body: first with the static world, then between bodies and characters.
     */
    void findContacts(TickBodies now, PortalWorld surroundings, BodyInfluences from, double tickSeconds) {
        begin(now, from, tickSeconds);
        rows.clear();
        int shapes = poses.count;
        int scratch = poses.add(BodyTable.BOX, motions.count - 1, -1);
        poses.upright(scratch);
        if (firstWithSolid.length <= bodies.count) {
            firstWithSolid = new int[bodies.count + 1];
        }
        for (int body = 0; body < bodies.count; body++) {
            firstWithSolid[body] = rows.count;
            if (bodies.isAwake(body)) {
                withStatics(body, surroundings.openedFor(bodies.active(body)), scratch);
            }
        }
        firstWithSolid[bodies.count] = rows.count;
        poses.count = shapes;
        findPairs();
        for (int i = 0; i < pairs.size(); i += 2) {
            addPair(pairs.get(i), pairs.get(i + 1));
        }
    }

    /** Returns true if the solver has contacts of a body and a solid of its world. */
    boolean metSolid(int body, int solid) {
        for (int m = firstWithSolid[body]; m < firstWithSolid[body + 1]; m++) {
            if (ContactCache.solid(rows.key[m]) == solid) {
                return true;
            }
        }
        return false;
    }

    /** Returns true if the solver has contacts of a body and another owner that do not act through a portal. */
    boolean metOther(int body, int other) {
        long parties = ContactCache.parties(ContactCache.between(Math.min(body, other), Math.max(body, other), -1));
        for (int m = firstWithSolid[bodies.count]; m < rows.count; m++) {
            if (ContactCache.parties(rows.key[m]) == parties) {
                return true;
            }
        }
        return false;
    }

    /** Returns the greatest distance in metres at which contacts are made ahead, at any speed. */
    double farMetres(int body) {
        return Math.max(poses.leastHalf(body) / 2, FAR_METRES);
    }

    private void withStatics(int body, CollisionWorld world, int scratch) {
        world.overlapping(poses.bounds, Poses.BOUNDS * body, near);
        double reach = reach(body);
        for (int i = 0; i < near.size(); i++) {
            Collider solid = world.collider(near.get(i));
            narrow.touch(body, solid, reach, scratch, manifold);
            if (manifold.count > 0) {
                Arrays.fill(offset, 0);
                long key = ContactCache.withSolid(body, near.get(i));
                add(
                        body,
                        motions.count - 1,
                        null,
                        key,
                        table.body(body).friction(),
                        table.body(body).restitution());
            }
        }
    }

    /** Makes rows for a pair. The first shape is real, the second may be an image: images come last. */
    private void addPair(int a, int b) {
        int ownerA = poses.owner[a];
        int ownerB = poses.owner[b];
        boolean bodyA = ownerA < bodies.count;
        boolean bodyB = ownerB < bodies.count;
        boolean awake = bodyA && bodies.isAwake(ownerA) || bodyB && bodies.isAwake(ownerB);
        if (!awake || !canMeet(a, b)) {
            return;
        }
        meet(a, b);
        if (manifold.count == 0) {
            return;
        }
        for (int i = 0; i < 3; i++) {
            offset[i] = poses.centre[3 * b + i] - poses.centre[3 * a + i];
        }
        double friction = Math.sqrt((bodyA ? table.body(ownerA).friction() : CHARACTER_FRICTION_COEFFICIENT)
                * (bodyB ? table.body(ownerB).friction() : CHARACTER_FRICTION_COEFFICIENT));
        double restitution = Math.max(
                bodyA ? table.body(ownerA).restitution() : 0,
                bodyB ? table.body(ownerB).restitution() : 0);
        int portal = poses.through[b];
        double[] turned = null;
        if (portal >= 0) {
            portalContacts.turn(portal, turn);
            turned = turn;
        }
        add(ownerA, ownerB, turned, ContactCache.between(ownerA, ownerB, portal), friction, restitution);
    }

    private void add(int ownerA, int ownerB, double[] turned, long parties, double friction, double restitution) {
        int m = rows.add(manifold, ownerA, ownerB, offset, turned);
        rows.key[m] = ContactCache.key(parties, manifold.code, manifold.count);
        rows.head[ContactRows.HEAD * m + ContactRows.FRICTION] = friction;
        rows.head[ContactRows.HEAD * m + ContactRows.RESTITUTION] = restitution;
        rows.head[ContactRows.HEAD * m + ContactRows.SLOP] = Math.min(SLOP_METRES, poses.leastHalf(ownerA) / 50);
        recall(m);
    }

    /** Warm starts a manifold: copies the impulses of the step before to the rows of the same points. */
    private void recall(int m) {
        int entry = entry(rows.key[m]);
        if (entry == NO_ENTRY) {
            return;
        }
        double scale = last.scaleTo(seconds);
        int known = ContactCache.points(last.key(entry));
        int features = last.features(entry);
        int used = 0;
        for (int i = 0; i < rows.points[m]; i++) {
            int wanted = rows.features[m] >>> 8 * i & 0xff;
            for (int j = 0; j < known; j++) {
                if ((used & 1 << j) == 0 && (features >>> 8 * j & 0xff) == wanted) {
                    used |= 1 << j;
                    int r = ContactRows.ROW * (rows.first[m] + i);
                    rows.rows[r + ContactRows.IMPULSE] = scale * last.impulse(entry, j);
                    rows.rows[r + ContactRows.GREATEST] = scale * last.impulse(entry, j);
                    break;
                }
            }
        }
        int f = ContactRows.HEAD * m + ContactRows.FRICTION_IMPULSE;
        for (int i = 0; i < 3; i++) {
            rows.head[f + i] = scale * last.impulse(entry, Manifold.MOST + i);
        }
    }

    /** Returns the contacts that had an impulse in this tick, and the stored ones of sleeping bodies. */
    ContactCache remember(TickBodies now) {
        int kept = 0;
        for (int i = 0; i < last.size(); i++) {
            kept += isKept(last.key(i), now) ? 1 : 0;
        }
        int carried = 0;
        for (int m = 0; m < rows.count; m++) {
            carried += isCarried(m, now) ? 1 : 0;
        }
        long[] keys = new long[kept + carried];
        int[] features = new int[kept + carried];
        float[] impulses = new float[(kept + carried) * ContactCache.IMPULSES];
        int at = 0;
        for (int i = 0; i < last.size(); i++) {
            if (isKept(last.key(i), now)) {
                keys[at] = last.key(i);
                features[at] = last.features(i);
                last.copyImpulses(i, seconds, impulses, at++);
            }
        }
        for (int m = 0; m < rows.count; m++) {
            if (isCarried(m, now)) {
                keys[at] = rows.key[m];
                features[at] = rows.features[m];
                rows.writeImpulses(m, impulses, ContactCache.IMPULSES * at++);
            }
        }
        return new ContactCache(keys, features, impulses, seconds);
    }

    /** Returns true if the impulses are worth storing; those of a body that then went through a portal are not. */
    private boolean isCarried(int m, TickBodies now) {
        int a = ContactCache.first(rows.key[m]);
        int b = ContactCache.second(rows.key[m]);
        return rows.carries(m)
                && !(a < now.count && now.hasCrossed(a))
                && !(b >= 0 && b < now.count && now.hasCrossed(b));
    }

    /** Returns true if neither body was awake in this tick, so that the stored contact is not among the rows. */
    private boolean isKept(long key, TickBodies now) {
        int a = ContactCache.first(key);
        int b = ContactCache.second(key);
        return a < now.count
                && motions.inverseMass[a] == 0
                && (b < 0 || b >= now.count || motions.inverseMass[b] == 0)
                && now.rest[a] == Bodies.ASLEEP;
    }

    /**
     * Lists every pair of shapes with overlapping bounds, two numbers each, the lower index first (sweep and prune: Baraff
     * 1992; Cohen et al. 1995): sorted along the axis on which the centres have the greatest variance, by least bound and
     * then by index, so that the order depends only on the bounds. Sorting starts from the last order.
     */
    private void findPairs() {
        pairs.clear();
        int axis = widestAxis();
        sort(axis);
        double[] bounds = poses.bounds;
        for (int i = 0; i < poses.count; i++) {
            int a = order[i];
            double until = bounds[Poses.BOUNDS * a + 3 + axis];
            for (int j = i + 1; j < poses.count && from[j] <= until; j++) {
                int b = order[j];
                if (poses.overlap(a, b)) {
                    pairs.accept(Math.min(a, b));
                    pairs.accept(Math.max(a, b));
                }
            }
        }
    }

    private int widestAxis() {
        int widest = 0;
        double most = -1;
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            double squares = 0;
            double origin = poses.count == 0 ? 0 : poses.centre[axis];
            for (int i = 0; i < poses.count; i++) {
                double c = poses.centre[3 * i + axis] - origin;
                sum += c;
                squares += c * c;
            }
            double variance = squares - sum * sum / Math.max(1, poses.count);
            if (variance > most) {
                most = variance;
                widest = axis;
            }
        }
        return widest;
    }

    private void sort(int axis) {
        if (order.length != poses.count) {
            order = new int[poses.count];
            from = new double[poses.count];
            Arrays.setAll(order, i -> i);
        }
        for (int i = 0; i < order.length; i++) {
            int shape = order[i];
            double least = poses.bounds[Poses.BOUNDS * shape + axis];
            int at = i;
            while (at > 0 && (from[at - 1] > least || (from[at - 1] == least && order[at - 1] > shape))) {
                from[at] = from[at - 1];
                order[at] = order[at - 1];
                at--;
            }
            from[at] = least;
            order[at] = shape;
        }
    }
}
