package nephele.engine.collision.rigid.solver;

import java.util.Arrays;

/**
 * The constraint rows of one island's contacts: their Jacobians by the bodies' velocities, and their response. A
 * manifold has one row along the normal for each point, then three of friction: two tangents and the rotation about the
 * normal. Reused.
 */
final class IslandRows {
    /** Compliance of a row as a fraction of its reciprocal effective mass: almost rigid, yet far above rounding. */
    static final double COMPLIANCE_FRACTION = 1e-8;

    /** Six doubles for each of the two bodies. */
    static final int JACOBIAN = 12;
    /** Offset of the second body's part. */
    static final int JACOBIAN_B = SolverState.STRIDE;

    static final int FRICTION_ROWS = 3;

    private final ContactRows contacts;
    int manifolds;
    int[] manifold = new int[16];
    int[] nodeA = new int[16];
    int[] nodeB = new int[16];
    int[] firstRow = new int[16];
    /** Greatest friction impulse by the normal impulses, N s. */
    double[] bound = new double[16];

    int rows;
    double[] jacobian = new double[64 * JACOBIAN];
    /** Reciprocal of a row's compliance, kg; kg m² for a rotation. */
    double[] stiffness = new double[64];
    /** Speed below which a normal row gives an impulse, m/s. */
    double[] target = new double[64];
    /** Impulse of the row when its speed is the target's, N s. */
    double[] bias = new double[64];

    /** True for bodies that nothing rotates. */
    private final boolean[] isUpright = new boolean[BlockCholesky.MOST_NODES];

    IslandRows(ContactRows contacts) {
        this.contacts = contacts;
    }

    void clear() {
        manifolds = 0;
        rows = 0;
    }

    void keepUpright(int node, boolean upright) {
        isUpright[node] = upright;
    }

    /** Adds the rows of a manifold between two bodies; −1 stands for what does not move. */
    void addManifold(int m, int a, int b) {
        int points = contacts.points[m];
        reserve(points + FRICTION_ROWS);
        manifold[manifolds] = m;
        nodeA[manifolds] = a;
        nodeB[manifolds] = b;
        firstRow[manifolds] = rows;
        manifolds++;
        double[] head = contacts.head;
        double[] from = contacts.rows;
        int h = ContactRows.HEAD * m;
        for (int i = 0; i < points; i++) {
            int r = ContactRows.ROW * (contacts.first[m] + i);
            writeRow(h + ContactRows.N_A, from, r, a, b);
            bias[rows] = from[r + ContactRows.IMPULSE];
            stiffness[rows++] = from[r + ContactRows.ROW_MASS] / COMPLIANCE_FRACTION;
        }
        double grip = Math.min(head[h + ContactRows.MASS], head[h + ContactRows.MASS + 1]);
        writeRow(h + ContactRows.U_A, head, h + ContactRows.U_ANGULAR, a, b);
        finishFriction(h, 0, grip);
        writeRow(h + ContactRows.W_A, head, h + ContactRows.W_ANGULAR, a, b);
        finishFriction(h, 1, grip);
        Arrays.fill(jacobian, JACOBIAN * rows, JACOBIAN * (rows + 1), 0);
        writeAngular(head, h + ContactRows.N_A, a, b);
        finishFriction(h, 2, head[h + ContactRows.MASS + 2]);
    }

    private void finishFriction(int h, int row, double effectiveMass) {
        bias[rows] = contacts.head[h + ContactRows.FRICTION_IMPULSE + row];
        target[rows] = 0;
        stiffness[rows++] = effectiveMass / COMPLIANCE_FRACTION;
    }

    private void writeRow(int linear, double[] angular, int at, int a, int b) {
        int to = JACOBIAN * rows;
        for (int i = 0; i < 3; i++) {
            jacobian[to + i] = contacts.head[linear + i];
            jacobian[to + JACOBIAN_B + i] = -contacts.head[linear + 3 + i];
        }
        writeAngular(angular, at, a, b);
    }

    private void writeAngular(double[] angular, int at, int a, int b) {
        int to = JACOBIAN * rows;
        for (int i = 0; i < 3; i++) {
            jacobian[to + SolverState.ANGULAR + i] = a < 0 || isUpright[a] ? 0 : angular[at + i];
            jacobian[to + JACOBIAN_B + SolverState.ANGULAR + i] = b < 0 || isUpright[b] ? 0 : -angular[at + 3 + i];
        }
    }

    private void reserve(int added) {
        if (manifolds == manifold.length) {
            int capacity = 2 * manifolds;
            manifold = Arrays.copyOf(manifold, capacity);
            nodeA = Arrays.copyOf(nodeA, capacity);
            nodeB = Arrays.copyOf(nodeB, capacity);
            firstRow = Arrays.copyOf(firstRow, capacity);
            bound = Arrays.copyOf(bound, capacity);
        }
        if (rows + added > stiffness.length) {
            int capacity = 2 * (rows + added);
            jacobian = Arrays.copyOf(jacobian, JACOBIAN * capacity);
            stiffness = Arrays.copyOf(stiffness, capacity);
            target = Arrays.copyOf(target, capacity);
            bias = Arrays.copyOf(bias, capacity);
        }
    }

    int points(int c) {
        return contacts.points[manifold[c]];
    }

    /** Returns the index after the last row of a manifold. */
    int end(int c) {
        return firstRow[c] + points(c) + FRICTION_ROWS;
    }

    /** Returns the bound of the angular impulse about a manifold's normal, N m s. */
    double turnBound(int c) {
        return bound[c] * contacts.head[ContactRows.HEAD * manifold[c] + ContactRows.TWIST_RADIUS];
    }

    /** Writes the speed of each row for velocities of six doubles a body. */
    void multiply(double[] v, double[] out) {
        for (int c = 0; c < manifolds; c++) {
            int end = end(c);
            int a = SolverState.STRIDE * nodeA[c];
            int b = SolverState.STRIDE * nodeB[c];
            for (int row = firstRow[c]; row < end; row++) {
                double sum = a < 0 ? 0 : dot(JACOBIAN * row, v, a);
                out[row] = b < 0 ? sum : sum + dot(JACOBIAN * row + JACOBIAN_B, v, b);
            }
        }
    }

    private double dot(int j, double[] v, int at) {
        return jacobian[j] * v[at]
                + jacobian[j + 1] * v[at + 1]
                + jacobian[j + 2] * v[at + 2]
                + jacobian[j + 3] * v[at + 3]
                + jacobian[j + 4] * v[at + 4]
                + jacobian[j + 5] * v[at + 5];
    }
}
