package nephele.engine.collision.rigid.solver;

import nephele.engine.collision.rigid.contact.Manifold;

/**
 * Sequential impulses in small steps (Catto 2005; Macklin et al. 2019, "Small Steps in Physics Simulation"; Catto 2024,
 * "Solver2D"): each substep is warm started, solves all rows once with a bias velocity that reduces overlap,
 * integrates, and solves them again without the bias, so that it leaves no velocity.
 */
final class ContactSolver {
    /**
     * Number of iterations over the points of one manifold before the next: with one only, the order of the points
     * makes towers rock.
     */
    private static final int ROUNDS_A_MANIFOLD = 3;

    /** Greatest bias velocity that reduces overlap. */
    private static final double PUSH_METRES_PER_SECOND = 2;

    /** Fraction of the overlap that a substep corrects. */
    private static final double PUSH_FRACTION = 0.1;

    private static final double BOUNCE_ABOVE_METRES_PER_SECOND = 0.3;

    /**
     * Depth above which an overlap was not caused by the simulation: its bias velocity needs more relaxing iterations.
     */
    private static final double DEEP_METRES = 0.05;

    private static final int DEEP_ROUNDS = 8;

    private final SolverState motions;
    private final ContactRows contacts;
    private boolean deep;
    private final double[] va = new double[SolverState.STRIDE];
    private final double[] vb = new double[SolverState.STRIDE];
    private final double[] aim = new double[Manifold.MOST];
    private int[] chosen = new int[0];
    private int count;

    ContactSolver(SolverState motions, ContactRows contacts) {
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Sets the manifolds to solve: the first {@code itsCount} of the list. */
    void begin(int[] manifolds, int itsCount) {
        chosen = manifolds;
        count = itsCount;
        deep = false;
        for (int c = 0; c < count; c++) {
            int m = chosen[c];
            for (int i = 0; i < contacts.points[m]; i++) {
                int row = contacts.first[m] + i;
                deep |= contacts.rows[ContactRows.ROW * row + ContactRows.GAP] < -DEEP_METRES;
            }
        }
    }

    void warmStart() {
        double[] head = contacts.head;
        double[] rows = contacts.rows;
        for (int c = 0; c < count; c++) {
            int m = chosen[c];
            int h = ContactRows.HEAD * m;
            load(m);
            double f = head[h + ContactRows.FRICTION_IMPULSE];
            if (f != 0) {
                apply(head, h + ContactRows.U_A, head, h + ContactRows.U_ANGULAR + ContactRows.TURNED_A, m, f);
            }
            f = head[h + ContactRows.FRICTION_IMPULSE + 1];
            if (f != 0) {
                apply(head, h + ContactRows.W_A, head, h + ContactRows.W_ANGULAR + ContactRows.TURNED_A, m, f);
            }
            f = head[h + ContactRows.FRICTION_IMPULSE + 2];
            if (f != 0) {
                applyTwist(head, h, f);
            }
            int r = ContactRows.ROW * contacts.first[m];
            for (int i = 0; i < contacts.points[m]; i++, r += ContactRows.ROW) {
                double impulse = rows[r + ContactRows.IMPULSE];
                if (impulse != 0) {
                    apply(head, h + ContactRows.N_A, rows, r + ContactRows.TURNED_A, m, impulse);
                }
            }
            store(m);
        }
    }

    /** Removes the velocity that the bias has left. */
    void relax(double h) {
        solve(h, false);
        for (int round = 0; deep && round < DEEP_ROUNDS; round++) {
            solve(h, false);
        }
    }

    /** @param push true to add the bias that reduces overlap */
    void solve(double h, boolean push) {
        for (int c = 0; c < count; c++) {
            int m = chosen[c];
            if (mayRub(m)) {
                load(m);
                solveFriction(m);
                store(m);
            }
            setTargets(m, 1 / h, push);
            solveNormals(m);
        }
    }

    /** Returns false if a manifold has neither normal nor friction impulses, so that its friction is zero. */
    private boolean mayRub(int m) {
        int r = ContactRows.ROW * contacts.first[m] + ContactRows.IMPULSE;
        for (int i = 0; i < contacts.points[m]; i++, r += ContactRows.ROW) {
            if (contacts.rows[r] != 0) {
                return true;
            }
        }
        int f = ContactRows.HEAD * m + ContactRows.FRICTION_IMPULSE;
        return contacts.head[f] != 0 || contacts.head[f + 1] != 0 || contacts.head[f + 2] != 0;
    }

    private void load(int m) {
        System.arraycopy(motions.velocity, SolverState.STRIDE * contacts.slotA[m], va, 0, SolverState.STRIDE);
        System.arraycopy(motions.velocity, SolverState.STRIDE * contacts.slotB[m], vb, 0, SolverState.STRIDE);
    }

    private void store(int m) {
        System.arraycopy(va, 0, motions.velocity, SolverState.STRIDE * contacts.slotA[m], SolverState.STRIDE);
        System.arraycopy(vb, 0, motions.velocity, SolverState.STRIDE * contacts.slotB[m], SolverState.STRIDE);
    }

    private void solveFriction(int m) {
        double[] head = contacts.head;
        int h = ContactRows.HEAD * m;
        double pressed = 0;
        int r = ContactRows.ROW * contacts.first[m] + ContactRows.IMPULSE;
        for (int i = 0; i < contacts.points[m]; i++, r += ContactRows.ROW) {
            pressed += contacts.rows[r];
        }
        int f = h + ContactRows.FRICTION_IMPULSE;
        double limit = head[h + ContactRows.FRICTION] * pressed;
        turning(h, limit * head[h + ContactRows.TWIST_RADIUS]);
        double u = head[f]
                - head[h + ContactRows.MASS] * speed(head, h + ContactRows.U_A, head, h + ContactRows.U_ANGULAR);
        double w = head[f + 1]
                - head[h + ContactRows.MASS + 1] * speed(head, h + ContactRows.W_A, head, h + ContactRows.W_ANGULAR);
        double square = u * u + w * w;
        if (square > limit * limit) {
            double scale = limit / Math.sqrt(square);
            u *= scale;
            w *= scale;
        }
        apply(head, h + ContactRows.U_A, head, h + ContactRows.U_ANGULAR + ContactRows.TURNED_A, m, u - head[f]);
        apply(head, h + ContactRows.W_A, head, h + ContactRows.W_ANGULAR + ContactRows.TURNED_A, m, w - head[f + 1]);
        head[f] = u;
        head[f + 1] = w;
    }

    private void turning(int h, double limit) {
        double[] head = contacts.head;
        int f = h + ContactRows.FRICTION_IMPULSE + 2;
        double speed = head[h] * va[3]
                + head[h + 1] * va[4]
                + head[h + 2] * va[5]
                - head[h + 3] * vb[3]
                - head[h + 4] * vb[4]
                - head[h + 5] * vb[5];
        double t = head[f] - head[h + ContactRows.MASS + 2] * speed;
        t = Math.max(-limit, Math.min(limit, t));
        applyTwist(head, h, t - head[f]);
        head[f] = t;
    }

    /** Computes for each point the speed at which its surfaces may approach, or negated must separate. */
    private void setTargets(int m, double perSecond, boolean push) {
        double[] rows = contacts.rows;
        int h = ContactRows.HEAD * m;
        double slop = contacts.head[h + ContactRows.SLOP];
        int r = ContactRows.ROW * contacts.first[m];
        for (int i = 0; i < contacts.points[m]; i++, r += ContactRows.ROW) {
            double gap = rows[r + ContactRows.GAP] + moved(m, h, r);
            if (gap > 0) {
                aim[i] = gap * perSecond;
            } else if (push) {
                aim[i] = Math.max(PUSH_FRACTION * perSecond * Math.min(0, gap + slop), -PUSH_METRES_PER_SECOND);
            } else {
                aim[i] = 0;
            }
        }
    }

    /**
     * Solves the normal rows, a few iterations over all points. Each number has its own variable: half of the step's
     * time is spent here.
     */
    private void solveNormals(int m) {
        double[] v = motions.velocity;
        double[] n = contacts.head;
        double[] rows = contacts.rows;
        int a = SolverState.STRIDE * contacts.slotA[m];
        int b = SolverState.STRIDE * contacts.slotB[m];
        int h = ContactRows.HEAD * m;
        int normalA = h + ContactRows.N_A;
        int normalB = h + ContactRows.N_B;
        double nax = n[normalA];
        double nay = n[normalA + 1];
        double naz = n[normalA + 2];
        double nbx = n[normalB];
        double nby = n[normalB + 1];
        double nbz = n[normalB + 2];
        double ia = motions.inverseMass[contacts.slotA[m]];
        double ib = motions.inverseMass[contacts.slotB[m]];
        // The relative linear velocity along the normal, and its change for a unit impulse.
        double parting = nax * v[a] + nay * v[a + 1] + naz * v[a + 2] - nbx * v[b] - nby * v[b + 1] - nbz * v[b + 2];
        double lightness = ia * (nax * nax + nay * nay + naz * naz) + ib * (nbx * nbx + nby * nby + nbz * nbz);
        double wax = v[a + 3];
        double way = v[a + 4];
        double waz = v[a + 5];
        double wbx = v[b + 3];
        double wby = v[b + 4];
        double wbz = v[b + 5];
        double sum = 0;
        int first = ContactRows.ROW * contacts.first[m];
        for (int round = 0; round < ROUNDS_A_MANIFOLD; round++) {
            int r = first;
            for (int i = 0; i < contacts.points[m]; i++, r += ContactRows.ROW) {
                double speed = parting
                        + rows[r] * wax
                        + rows[r + 1] * way
                        + rows[r + 2] * waz
                        - rows[r + 3] * wbx
                        - rows[r + 4] * wby
                        - rows[r + 5] * wbz;
                double now = rows[r + ContactRows.IMPULSE];
                double then = Math.max(0, now - rows[r + ContactRows.ROW_MASS] * (speed + aim[i]));
                double change = then - now;
                if (change == 0) {
                    continue;
                }
                rows[r + ContactRows.IMPULSE] = then;
                rows[r + ContactRows.GREATEST] = Math.max(rows[r + ContactRows.GREATEST], then);
                sum += change;
                parting += lightness * change;
                wax += change * rows[r + ContactRows.TURNED_A];
                way += change * rows[r + ContactRows.TURNED_A + 1];
                waz += change * rows[r + ContactRows.TURNED_A + 2];
                wbx -= change * rows[r + ContactRows.TURNED_B];
                wby -= change * rows[r + ContactRows.TURNED_B + 1];
                wbz -= change * rows[r + ContactRows.TURNED_B + 2];
            }
        }
        v[a] += sum * ia * nax;
        v[a + 1] += sum * ia * nay;
        v[a + 2] += sum * ia * naz;
        v[a + 3] = wax;
        v[a + 4] = way;
        v[a + 5] = waz;
        v[b] -= sum * ib * nbx;
        v[b + 1] -= sum * ib * nby;
        v[b + 2] -= sum * ib * nbz;
        v[b + 3] = wbx;
        v[b + 4] = wby;
        v[b + 5] = wbz;
    }

    /** Returns the change of the surfaces' distance since the tick began. */
    private double moved(int m, int h, int r) {
        double[] d = motions.moved;
        double[] n = contacts.head;
        double[] rows = contacts.rows;
        int a = SolverState.STRIDE * contacts.slotA[m];
        int b = SolverState.STRIDE * contacts.slotB[m];
        return n[h] * d[a]
                + n[h + 1] * d[a + 1]
                + n[h + 2] * d[a + 2]
                + rows[r] * d[a + 3]
                + rows[r + 1] * d[a + 4]
                + rows[r + 2] * d[a + 5]
                - n[h + 3] * d[b]
                - n[h + 4] * d[b + 1]
                - n[h + 5] * d[b + 2]
                - rows[r + 3] * d[b + 3]
                - rows[r + 4] * d[b + 4]
                - rows[r + 5] * d[b + 5];
    }

    private double speed(double[] linear, int l, double[] angular, int k) {
        return linear[l] * va[0]
                + linear[l + 1] * va[1]
                + linear[l + 2] * va[2]
                + angular[k] * va[3]
                + angular[k + 1] * va[4]
                + angular[k + 2] * va[5]
                - linear[l + 3] * vb[0]
                - linear[l + 4] * vb[1]
                - linear[l + 5] * vb[2]
                - angular[k + 3] * vb[3]
                - angular[k + 4] * vb[4]
                - angular[k + 5] * vb[5];
    }

    /** @param k index of the angular parts multiplied by the inverse inertia */
    private void apply(double[] linear, int l, double[] angular, int k, int m, double impulse) {
        double ia = impulse * motions.inverseMass[contacts.slotA[m]];
        double ib = impulse * motions.inverseMass[contacts.slotB[m]];
        va[0] += ia * linear[l];
        va[1] += ia * linear[l + 1];
        va[2] += ia * linear[l + 2];
        va[3] += impulse * angular[k];
        va[4] += impulse * angular[k + 1];
        va[5] += impulse * angular[k + 2];
        vb[0] -= ib * linear[l + 3];
        vb[1] -= ib * linear[l + 4];
        vb[2] -= ib * linear[l + 5];
        vb[3] -= impulse * angular[k + 3];
        vb[4] -= impulse * angular[k + 4];
        vb[5] -= impulse * angular[k + 5];
    }

    private void applyTwist(double[] head, int h, double impulse) {
        int k = h + ContactRows.TWIST;
        for (int i = 0; i < 3; i++) {
            va[3 + i] += impulse * head[k + i];
            vb[3 + i] -= impulse * head[k + 3 + i];
        }
    }

    /** Applies Newton's restitution once, after the substeps: surfaces separate at a fraction of their approach speed. */
    void bounce() {
        double[] rows = contacts.rows;
        for (int m = 0; m < contacts.count; m++) {
            double fraction = contacts.head[ContactRows.HEAD * m + ContactRows.RESTITUTION];
            if (fraction == 0) {
                continue;
            }
            load(m);
            int h = ContactRows.HEAD * m;
            int r = ContactRows.ROW * contacts.first[m];
            for (int i = 0; i < contacts.points[m]; i++, r += ContactRows.ROW) {
                double approach = rows[r + ContactRows.APPROACH];
                if (approach > -BOUNCE_ABOVE_METRES_PER_SECOND || rows[r + ContactRows.GREATEST] == 0) {
                    continue;
                }
                double now = rows[r + ContactRows.IMPULSE];
                double speed = speed(contacts.head, h, rows, r) + fraction * approach;
                double impulse = Math.max(0, now - rows[r + ContactRows.ROW_MASS] * speed);
                rows[r + ContactRows.IMPULSE] = impulse;
                apply(contacts.head, h, rows, r + ContactRows.TURNED_A, m, impulse - now);
            }
            store(m);
        }
    }
}
