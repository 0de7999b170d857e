package nephele.engine.collision.rigid.solver;

import java.util.Arrays;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;

/**
 * Chooses a solver for the contacts of each island and runs it: the exact {@link IslandSolver} if few bodies move or
 * sequential impulses would be slow or wrong, the substeps of {@link ContactSolver} otherwise. Reused.
 */
public final class StepSolver {
    /** Substeps of a second, rounded to a whole number a tick: four at 120 ticks a second. */
    private static final double SUBSTEPS_A_SECOND = 480;

    private static final int MOST_SUBSTEPS = 32;

    /** Greatest ratio of masses in contact that counts as even. */
    private static final double EVEN_MASSES = 2;

    /** Greatest ratio of a body's edges that counts as even. */
    private static final double EVEN_EDGES = 4;

    /** Number of awake bodies up to which every island is solved exactly. */
    private static final int FEW_BODIES = 32;

    /** Block products for each body that the exact solver may use on an island. */
    private static final double MOST_PRODUCTS_A_BODY = 12;

    private final BodyTable table;
    private final Vec3 gravity;
    private final SolverState motions;
    private final ContactRows rows;
    private final Islands islands = new Islands();
    private final IslandSolver exact;
    private final ContactSolver sequential;
    /** True for slots that the substeps move. */
    private boolean[] stepped = new boolean[0];
    /** Manifolds that the substeps solve. */
    private int[] left = new int[0];

    public StepSolver(BodyTable table, Vec3 gravity, SolverState motions, ContactRows rows) {
        this.table = table;
        this.gravity = gravity;
        this.motions = motions;
        this.rows = rows;
        exact = new IslandSolver(rows, motions);
        sequential = new ContactSolver(motions, rows);
    }

    /**
     * Changes the velocities in {@link SolverState} by the contacts and by gravity, and sums up the displacements.
     *
     * @param slots bodies and characters
     * @param weighs true for slots on which gravity acts
     */
    public void solve(int slots, int awake, boolean[] weighs, double seconds) {
        if (rows.count == 0) {
            return;
        }
        rows.rememberApproach();
        islands.sort(rows, motions, slots);
        if (stepped.length < slots + 1) {
            stepped = new boolean[slots + 64];
        }
        Arrays.fill(stepped, 0, slots, false);
        if (left.length < rows.count) {
            left = new int[2 * rows.count];
        }
        int[] order = islands.order();
        int count = 0;
        for (int i = 0; i < islands.count(); ) {
            int end = islands.end(i);
            boolean isExact = awake <= FEW_BODIES || isHard(order, i, end);
            if (isExact && exact.begin(order, i, end, MOST_PRODUCTS_A_BODY)) {
                exact.solve(gravity, weighs, seconds);
            } else {
                for (int k = i; k < end; k++) {
                    stepped[rows.slotA[order[k]]] = true;
                    stepped[rows.slotB[order[k]]] = true;
                    left[count++] = order[k];
                }
            }
            i = end;
        }
        if (count > 0) {
            solveInSubsteps(count, slots, weighs, seconds);
        }
        sequential.bounce();
    }

    /** Returns true if an island has unequal masses or thin bodies, for which sequential impulses are slow or wrong. */
    private boolean isHard(int[] order, int from, int to) {
        for (int i = from; i < to; i++) {
            int a = rows.slotA[order[i]];
            int b = rows.slotB[order[i]];
            double ia = motions.inverseMass[a];
            double ib = motions.inverseMass[b];
            boolean uneven = ia > 0 && ib > 0 && Math.max(ia, ib) > EVEN_MASSES * Math.min(ia, ib);
            if (uneven || isThin(a) || isThin(b)) {
                return true;
            }
        }
        return false;
    }

    private boolean isThin(int slot) {
        return slot < table.size() && table.slenderness(slot) > EVEN_EDGES;
    }

    private void solveInSubsteps(int count, int slots, boolean[] weighs, double seconds) {
        int substeps = (int) Math.max(2, Math.min(MOST_SUBSTEPS, Math.round(seconds * SUBSTEPS_A_SECOND)));
        double h = seconds / substeps;
        for (int i = 0; i < count; i++) {
            rows.scaleImpulses(left[i], 1.0 / substeps);
        }
        sequential.begin(left, count);
        for (int i = 0; i < substeps; i++) {
            weigh(slots, weighs, h);
            sequential.warmStart();
            sequential.solve(h, true);
            advance(slots, h);
            sequential.relax(h);
        }
        for (int i = 0; i < count; i++) {
            rows.scaleImpulses(left[i], substeps);
        }
    }

    private void weigh(int slots, boolean[] weighs, double h) {
        for (int slot = 0; slot < slots; slot++) {
            if (stepped[slot] && weighs[slot]) {
                motions.velocity[SolverState.STRIDE * slot] += gravity.x() * h;
                motions.velocity[SolverState.STRIDE * slot + 1] += gravity.y() * h;
                motions.velocity[SolverState.STRIDE * slot + 2] += gravity.z() * h;
            }
        }
    }

    private void advance(int slots, double h) {
        for (int slot = 0; slot < slots; slot++) {
            for (int i = SolverState.STRIDE * slot; stepped[slot] && i < SolverState.STRIDE * (slot + 1); i++) {
                motions.moved[i] += h * motions.velocity[i];
            }
        }
    }
}
