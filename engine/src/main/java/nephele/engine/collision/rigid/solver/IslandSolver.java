package nephele.engine.collision.rigid.solver;

import nephele.engine.math.Vec3;

/**
 * Solves the contacts of one island to rounding error, for any masses: Newton's method with an exact line search on the
 * convex function of {@link IslandSystem}. Each round starts from the impulses of the one before (augmented Lagrangian,
 * Hestenes 1969), and its friction is bounded by their normal impulses. The velocities never gain energy: with no
 * target above zero they are the nearest to the free ones that the contacts allow. Reused.
 */
final class IslandSolver {
    private static final int MOST_ROUNDS = 24;

    /** First round from which friction bounds change by half: whole changes make some oscillate for ever. */
    private static final int RELAXED_ROUND = 4;

    private static final int MOST_NEWTON_STEPS = 40;
    private static final int MOST_LINE_STEPS = 30;
    /** A line search ends when the slope is this fraction of the initial one. */
    private static final double SLOPE_FRACTION = 0.05;

    private static final double SETTLED_METRES_PER_SECOND = 1e-6;
    /** Greatest speed at which overlap is reduced. */
    private static final double PUSH_METRES_PER_SECOND = 2;

    /** Greatest fraction of a gap, in metres, that moving by the mean of two velocities may lose. */
    private static final double SMOOTH_METRES = 2e-5;

    /** Fraction of an overlap that a part corrects, however short it is: a curved path makes new overlap in every part. */
    private static final double PUSH_FRACTION = 1 / 3.0;

    /**
     * Greatest displacement by overlap correction, as a multiple of the overlap: a body stuck in two solids would be
     * thrown.
     */
    private static final double MOST_LEVER = 4;

    private final ContactRows contacts;
    private final SolverState motions;
    private final BlockCholesky matrix = new BlockCholesky();
    private final IslandSystem system;
    private final IslandRows rows;
    private final double[] step = new double[SolverState.STRIDE * BlockCholesky.MOST_NODES];
    private int[] nodeOf = new int[0];

    IslandSolver(ContactRows contacts, SolverState motions) {
        this.contacts = contacts;
        this.motions = motions;
        system = new IslandSystem(contacts, motions, matrix);
        rows = system.rows;
    }

    /**
     * Sets the island to solve.
     *
     * @param list numbers of manifolds; the island's are from {@code from} to before {@code to}
     * @param most greatest number of block products of a factorisation, for each body
     * @return false when it has too many bodies or too dense a net of contacts: another solver must then solve it
     */
    boolean begin(int[] list, int from, int to, double most) {
        if (nodeOf.length < motions.count) {
            nodeOf = new int[motions.count];
        }
        system.clear();
        for (int i = from; i < to; i++) {
            nodeOf[contacts.slotA[list[i]]] = -1;
            nodeOf[contacts.slotB[list[i]]] = -1;
        }
        for (int i = from; i < to; i++) {
            if (!addNode(contacts.slotA[list[i]]) || !addNode(contacts.slotB[list[i]])) {
                return false;
            }
        }
        matrix.begin(system.nodes);
        for (int i = from; i < to; i++) {
            int a = nodeOf[contacts.slotA[list[i]]];
            int b = nodeOf[contacts.slotB[list[i]]];
            if (a >= 0 && b >= 0) {
                matrix.link(a, b);
            }
        }
        if (matrix.analyse() > most * system.nodes) {
            return false;
        }
        for (int i = from; i < to; i++) {
            rows.addManifold(list[i], nodeOf[contacts.slotA[list[i]]], nodeOf[contacts.slotB[list[i]]]);
        }
        system.ready();
        return true;
    }

    private boolean addNode(int slot) {
        if (motions.inverseMass[slot] == 0 || nodeOf[slot] >= 0) {
            return true;
        }
        if (system.nodes == BlockCholesky.MOST_NODES) {
            return false;
        }
        nodeOf[slot] = system.addNode(slot);
        return true;
    }

    /**
     * Changes the island's velocities by its contacts and its weight over a tick.
     *
     * @param weighs true for slots on which gravity acts
     */
    void solve(Vec3 gravity, boolean[] weighs, double seconds) {
        for (int node = 0; node < system.nodes; node++) {
            int slot = system.slot[node];
            System.arraycopy(
                    motions.velocity,
                    SolverState.STRIDE * slot,
                    system.free,
                    SolverState.STRIDE * node,
                    SolverState.STRIDE);
            System.arraycopy(
                    motions.velocity,
                    SolverState.STRIDE * slot,
                    system.velocity,
                    SolverState.STRIDE * node,
                    SolverState.STRIDE);
            double fall = weighs[slot] ? seconds : 0;
            system.free[SolverState.STRIDE * node] += fall * gravity.x();
            system.free[SolverState.STRIDE * node + 1] += fall * gravity.y();
            system.free[SolverState.STRIDE * node + 2] += fall * gravity.z();
        }
        boolean overlapping = setTargets(seconds, false);
        bound();
        system.findSpeeds();
        for (int round = 0; round < MOST_ROUNDS; round++) {
            minimise();
            if (settle(round >= RELAXED_ROUND)) {
                break;
            }
        }
        boolean smooth = !overlapping && isSmooth(seconds);
        write(motions.moved, seconds);
        if (smooth) {
            takeMeanDisplacement(seconds);
        }
        write(motions.velocity, 1);
        writeImpulses();
        if (overlapping) {
            setTargets(seconds, true);
            minimise();
            takePushedDisplacement(seconds);
            markPushed();
        }
    }

    /** Moves by the velocities that correct overlap; by a fraction of them if overlaps contradict each other. */
    private void takePushedDisplacement(double seconds) {
        double greatest = 0;
        for (int c = 0; c < rows.manifolds; c++) {
            for (int row = rows.firstRow[c]; row < rows.firstRow[c] + rows.points(c); row++) {
                greatest = Math.max(greatest, rows.target[row]);
            }
        }
        double fastest = 0;
        for (int node = 0; node < system.nodes; node++) {
            fastest = Math.max(fastest, system.speedBeyond(node, motions.moved, 1 / seconds));
        }
        double fraction = Math.min(1, MOST_LEVER * greatest / fastest);
        for (int node = 0; node < system.nodes; node++) {
            int at = SolverState.STRIDE * system.slot[node];
            for (int i = 0; i < SolverState.STRIDE; i++) {
                double pushed = seconds * system.velocity[SolverState.STRIDE * node + i];
                motions.moved[at + i] += fraction * (pushed - motions.moved[at + i]);
            }
        }
    }

    /** Marks the rows that correct overlap as carrying, although no impulse is left of the correction. */
    private void markPushed() {
        for (int c = 0; c < rows.manifolds; c++) {
            int m = rows.manifold[c];
            for (int i = 0; i < rows.points(c); i++) {
                int r = ContactRows.ROW * (contacts.first[m] + i) + ContactRows.GREATEST;
                contacts.rows[r] = Math.max(contacts.rows[r], system.impulse[rows.firstRow[c] + i]);
            }
        }
    }

    /** Returns true if no active row changes its speed by an amount that matters over half of the displacement. */
    private boolean isSmooth(double seconds) {
        for (int c = 0; c < rows.manifolds; c++) {
            int m = rows.manifold[c];
            for (int i = 0; i < rows.points(c); i++) {
                int row = rows.firstRow[c] + i;
                double before = contacts.rows[ContactRows.ROW * (contacts.first[m] + i) + ContactRows.APPROACH];
                if (system.impulse[row] > 0 && !(Math.abs(system.speed(row) - before) * seconds < SMOOTH_METRES)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Moves by the mean of the velocities before and after: second order in time without impacts. */
    private void takeMeanDisplacement(double seconds) {
        for (int node = 0; node < system.nodes; node++) {
            int at = SolverState.STRIDE * system.slot[node];
            for (int i = at; i < at + SolverState.STRIDE; i++) {
                motions.moved[i] += (motions.velocity[i] * seconds - motions.moved[i]) / 2;
            }
        }
    }

    /** Sets the rows' targets; returns true if a surface overlaps by more than the allowed depth. */
    private boolean setTargets(double seconds, boolean push) {
        boolean overlapping = false;
        for (int c = 0; c < rows.manifolds; c++) {
            int m = rows.manifold[c];
            double slop = contacts.head[ContactRows.HEAD * m + ContactRows.SLOP];
            for (int i = 0; i < rows.points(c); i++) {
                double gap = contacts.rows[ContactRows.ROW * (contacts.first[m] + i) + ContactRows.GAP];
                double over = Math.max(0, -gap - slop);
                overlapping |= over > 0;
                double pushed = push ? Math.min(PUSH_FRACTION * over / seconds, PUSH_METRES_PER_SECOND) : 0;
                rows.target[rows.firstRow[c] + i] = gap > 0 ? -gap / seconds : pushed;
            }
        }
        return overlapping;
    }

    /** Bounds the friction by the stored normal impulses. */
    private void bound() {
        for (int c = 0; c < rows.manifolds; c++) {
            rows.bound[c] = friction(c, rows.bias);
        }
    }

    private double friction(int c, double[] impulses) {
        double pressed = 0;
        for (int i = 0; i < rows.points(c); i++) {
            pressed += impulses[rows.firstRow[c] + i];
        }
        return pressed * contacts.head[ContactRows.HEAD * rows.manifold[c] + ContactRows.FRICTION];
    }

    /** Stores the impulses found; returns true if they have converged. */
    private boolean settle(boolean relaxed) {
        boolean settled = true;
        for (int c = 0; c < rows.manifolds; c++) {
            int friction = rows.firstRow[c] + rows.points(c);
            for (int row = rows.firstRow[c]; row < rows.end(c); row++) {
                double change = Math.abs(system.impulse[row] - rows.bias[row]);
                settled &= change <= SETTLED_METRES_PER_SECOND * rows.stiffness[row];
                rows.bias[row] = system.impulse[row];
            }
            double now = friction(c, system.impulse);
            // A change of a bound acts on the lighter body directly, without compliance between.
            double change = Math.abs(now - rows.bound[c]) / (IslandRows.COMPLIANCE_FRACTION * rows.stiffness[friction]);
            settled &= change <= 1e-4 || now >= rows.bound[c] && sticks(c, friction);
            rows.bound[c] = relaxed ? (now + rows.bound[c]) / 2 : now;
        }
        return settled;
    }

    private boolean sticks(int c, int friction) {
        double u = system.impulse[friction];
        double w = system.impulse[friction + 1];
        return u * u + w * w < 0.999 * rows.bound[c] * rows.bound[c];
    }

    private void minimise() {
        system.findImpulses();
        for (int i = 0; i < MOST_NEWTON_STEPS; i++) {
            long pattern = system.pattern;
            system.findGradient();
            system.assemble();
            matrix.factorise();
            newtonStep();
            system.along(step);
            double fraction = lineSearch();
            system.go(step, fraction);
            system.findImpulses();
            if (fraction == 1 && (pattern == system.pattern && !system.slides || isSmall())) {
                refine();
                return;
            }
        }
    }

    /** Removes the rounding error of the gradient with the present factor, which conserves momentum. */
    private void refine() {
        system.findGradient();
        newtonStep();
        system.along(step);
        system.go(step, 1);
        system.findImpulses();
    }

    private void newtonStep() {
        for (int k = 0; k < SolverState.STRIDE * system.nodes; k++) {
            step[k] = -system.gradient[k];
        }
        matrix.solve(step);
    }

    private boolean isSmall() {
        for (int k = 0; k < SolverState.STRIDE * system.nodes; k++) {
            if (!(Math.abs(step[k]) < SETTLED_METRES_PER_SECOND)) {
                return false;
            }
        }
        return true;
    }

    /** Returns the fraction of the step that nearly minimises the function; the whole step if that is good enough. */
    private double lineSearch() {
        double first = system.slope(0);
        if (!(first < 0)) {
            return 1;
        }
        double slope = system.slope(1);
        if (slope <= -SLOPE_FRACTION * first) {
            return 1;
        }
        double low = 0;
        double high = 1;
        double fraction = 1;
        for (int i = 0; i < MOST_LINE_STEPS && Math.abs(slope) > -SLOPE_FRACTION * first; i++) {
            if (slope > 0) {
                high = fraction;
            } else {
                low = fraction;
            }
            fraction -= slope / system.curvature;
            if (!(fraction > low && fraction < high)) {
                fraction = (low + high) / 2;
            }
            slope = system.slope(fraction);
        }
        return fraction;
    }

    private void write(double[] out, double factor) {
        for (int node = 0; node < system.nodes; node++) {
            for (int i = 0; i < SolverState.STRIDE; i++) {
                out[SolverState.STRIDE * system.slot[node] + i] =
                        factor * system.velocity[SolverState.STRIDE * node + i];
            }
        }
    }

    private void writeImpulses() {
        for (int c = 0; c < rows.manifolds; c++) {
            int m = rows.manifold[c];
            int row = rows.firstRow[c];
            for (int i = 0; i < rows.points(c); i++, row++) {
                int r = ContactRows.ROW * (contacts.first[m] + i);
                contacts.rows[r + ContactRows.IMPULSE] = system.impulse[row];
                contacts.rows[r + ContactRows.GREATEST] = system.impulse[row];
            }
            for (int i = 0; i < 3; i++) {
                contacts.head[ContactRows.HEAD * m + ContactRows.FRICTION_IMPULSE + i] = system.impulse[row + i];
            }
        }
    }
}
