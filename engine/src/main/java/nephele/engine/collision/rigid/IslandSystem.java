package nephele.engine.collision.rigid;

import java.util.Arrays;

/**
 * The contacts of one island as a convex function of the bodies' velocities v: half of (v − v₀)ᵀ M (v − v₀), where v₀ is
 * the velocity without contacts, plus for each row the energy of a very stiff one-sided spring along a normal, or of one
 * that slips at a bound along a tangent (Castro, Permenter and Han 2022, "An unconstrained convex formulation of
 * compliant contact", with friction bounded as in Tamis 2015). Its least value is where impulses and velocities agree.
 * Six doubles a body: linear, angular, world axes. Reused for every island.
 */
final class IslandSystem {
    /** Compliance of a row as a share of its reciprocal effective mass: next to none, yet far above rounding. */
    private static final double COMPLIANCE_SHARE = 1e-8;

    private static final int JACOBIAN = 12;
    /** Rows of friction a manifold: two tangents and the turn about the normal. */
    private static final int FRICTION_ROWS = 3;

    private final ContactRows contacts;
    private final Motions motions;
    private final BlockCholesky matrix;

    int nodes;
    /** The slot of each body in {@link Motions}. */
    final int[] slot = new int[BlockCholesky.MOST_NODES];

    private final double[] mass = new double[BlockCholesky.MOST_NODES];
    /** World axes, symmetric: xx, xy, xz, yy, yz, zz. */
    private final double[] inertia = new double[6 * BlockCholesky.MOST_NODES];

    final double[] free = new double[6 * BlockCholesky.MOST_NODES];
    final double[] velocity = new double[6 * BlockCholesky.MOST_NODES];
    final double[] gradient = new double[6 * BlockCholesky.MOST_NODES];

    int manifolds;
    int[] manifold = new int[16];
    private int[] nodeA = new int[16];
    private int[] nodeB = new int[16];
    int[] firstRow = new int[16];
    /** N s that friction may give, by what presses. */
    double[] bound = new double[16];

    int rows;
    private double[] jacobian = new double[64 * JACOBIAN];
    /** kg, of a turn kg m²: the reciprocal of a row's compliance. */
    double[] stiffness = new double[64];
    /** The speed at which a normal row begins to press, m/s. */
    double[] target = new double[64];
    /** Impulse of the row where its speed is the target's, N s. */
    double[] bias = new double[64];

    double[] impulse = new double[64];
    private double[] speed = new double[64];
    private double[] change = new double[64];
    private final double[] across = new double[JACOBIAN];

    IslandSystem(ContactRows contacts, Motions motions, BlockCholesky matrix) {
        this.contacts = contacts;
        this.motions = motions;
        this.matrix = matrix;
    }

    void clear() {
        nodes = 0;
        manifolds = 0;
        rows = 0;
    }

    /** Adds a body and returns its number here. */
    int addNode(int itsSlot) {
        int node = nodes++;
        slot[node] = itsSlot;
        mass[node] = 1 / motions.inverseMass[itsSlot];
        System.arraycopy(motions.inertia, 6 * itsSlot, inertia, 6 * node, 6);
        return node;
    }

    /** Adds the rows of a manifold between two bodies, −1 for what does not move. */
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
            stiffness[rows++] = from[r + ContactRows.ROW_MASS] / COMPLIANCE_SHARE;
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
        stiffness[rows++] = effectiveMass / COMPLIANCE_SHARE;
    }

    private void writeRow(int linear, double[] angular, int at, int a, int b) {
        int to = JACOBIAN * rows;
        for (int i = 0; i < 3; i++) {
            jacobian[to + i] = contacts.head[linear + i];
            jacobian[to + 6 + i] = -contacts.head[linear + 3 + i];
        }
        writeAngular(angular, at, a, b);
    }

    private void writeAngular(double[] angular, int at, int a, int b) {
        int to = JACOBIAN * rows;
        for (int i = 0; i < 3; i++) {
            jacobian[to + 3 + i] = a < 0 || motions.isUpright(slot[a]) ? 0 : angular[at + i];
            jacobian[to + 9 + i] = b < 0 || motions.isUpright(slot[b]) ? 0 : -angular[at + 3 + i];
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
            impulse = Arrays.copyOf(impulse, capacity);
            speed = Arrays.copyOf(speed, capacity);
            change = Arrays.copyOf(change, capacity);
        }
    }

    int points(int c) {
        return contacts.points[manifold[c]];
    }

    /** Speed of a row as last computed, positive where the surfaces part. */
    double speed(int row) {
        return speed[row];
    }

    /** Computes every row's speed from the velocities. */
    void findSpeeds() {
        multiply(velocity, speed);
    }

    private void multiply(double[] v, double[] out) {
        for (int c = 0; c < manifolds; c++) {
            int end = firstRow[c] + points(c) + FRICTION_ROWS;
            int a = 6 * nodeA[c];
            int b = 6 * nodeB[c];
            for (int row = firstRow[c]; row < end; row++) {
                double sum = a < 0 ? 0 : dot(JACOBIAN * row, v, a);
                out[row] = b < 0 ? sum : sum + dot(JACOBIAN * row + 6, v, b);
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

    /** Names which rows press and stick: equal where the function is the same quadratic one. */
    long pattern;

    /** Whether a manifold slides: there the function is no quadratic one. */
    boolean slides;

    /** Computes every row's impulse from its speed. */
    void findImpulses() {
        pattern = 0;
        slides = false;
        for (int c = 0; c < manifolds; c++) {
            int friction = firstRow[c] + points(c);
            for (int row = firstRow[c]; row < friction; row++) {
                impulse[row] = Math.max(0, bias[row] - stiffness[row] * (speed[row] - target[row]));
                pattern = 31 * pattern + (impulse[row] > 0 ? 1 : 0);
            }
            double u = bias[friction] - stiffness[friction] * speed[friction];
            double w = bias[friction + 1] - stiffness[friction + 1] * speed[friction + 1];
            double square = u * u + w * w;
            double scale = square > bound[c] * bound[c] ? bound[c] / Math.sqrt(square) : 1;
            slides |= scale < 1 && bound[c] > 0;
            pattern = 31 * pattern + (scale < 1 ? 1 : 0);
            impulse[friction] = scale * u;
            impulse[friction + 1] = scale * w;
            double most = turnBound(c);
            double turn = bias[friction + 2] - stiffness[friction + 2] * speed[friction + 2];
            impulse[friction + 2] = Math.max(-most, Math.min(most, turn));
            pattern = 31 * pattern + (turn > most ? 1 : turn < -most ? 2 : 0);
        }
    }

    private double turnBound(int c) {
        return bound[c] * contacts.head[ContactRows.HEAD * manifold[c] + ContactRows.TWIST_RADIUS];
    }

    /** Computes the gradient: momentum that differs from the free one's, less what the rows give. */
    void findGradient() {
        for (int node = 0; node < nodes; node++) {
            momentum(node, velocity, free, gradient);
        }
        for (int c = 0; c < manifolds; c++) {
            int end = firstRow[c] + points(c) + FRICTION_ROWS;
            for (int row = firstRow[c]; row < end; row++) {
                if (impulse[row] != 0) {
                    give(row, nodeA[c], nodeB[c], -impulse[row]);
                }
            }
        }
    }

    private void give(int row, int a, int b, double amount) {
        int j = JACOBIAN * row;
        for (int i = 0; a >= 0 && i < 6; i++) {
            gradient[6 * a + i] += amount * jacobian[j + i];
        }
        for (int i = 0; b >= 0 && i < 6; i++) {
            gradient[6 * b + i] += amount * jacobian[j + 6 + i];
        }
    }

    /** Mass matrix of a body times a difference of velocities. */
    private void momentum(int node, double[] v, double[] less, double[] out) {
        int at = 6 * node;
        double x = v[at + 3] - less[at + 3];
        double y = v[at + 4] - less[at + 4];
        double z = v[at + 5] - less[at + 5];
        for (int i = 0; i < 3; i++) {
            out[at + i] = mass[node] * (v[at + i] - less[at + i]);
        }
        out[at + 3] = inertia[at] * x + inertia[at + 1] * y + inertia[at + 2] * z;
        out[at + 4] = inertia[at + 1] * x + inertia[at + 3] * y + inertia[at + 4] * z;
        out[at + 5] = inertia[at + 2] * x + inertia[at + 4] * y + inertia[at + 5] * z;
    }

    /** Fills the matrix with the second derivative at the rows' present speeds. */
    void assemble() {
        matrix.clear();
        double[] m = matrix.values();
        for (int node = 0; node < nodes; node++) {
            int d = matrix.diagonal(node);
            int i = 6 * node;
            m[d] = mass[node];
            m[d + 7] = mass[node];
            m[d + 14] = mass[node];
            m[d + 21] = inertia[i];
            m[d + 27] = inertia[i + 1];
            m[d + 28] = inertia[i + 3];
            m[d + 33] = inertia[i + 2];
            m[d + 34] = inertia[i + 4];
            m[d + 35] = inertia[i + 5];
        }
        for (int c = 0; c < manifolds; c++) {
            int friction = firstRow[c] + points(c);
            for (int row = firstRow[c]; row < friction; row++) {
                if (bias[row] > stiffness[row] * (speed[row] - target[row])) {
                    addSquare(c, stiffness[row], jacobian, JACOBIAN * row);
                }
            }
            assembleFriction(c, friction);
        }
    }

    private void assembleFriction(int c, int row) {
        if (bound[c] == 0) {
            return;
        }
        double u = bias[row] - stiffness[row] * speed[row];
        double w = bias[row + 1] - stiffness[row + 1] * speed[row + 1];
        double length = Math.sqrt(u * u + w * w);
        if (length <= bound[c]) {
            addSquare(c, stiffness[row], jacobian, JACOBIAN * row);
            addSquare(c, stiffness[row + 1], jacobian, JACOBIAN * (row + 1));
        } else {
            for (int i = 0; i < JACOBIAN; i++) {
                across[i] = (u * jacobian[JACOBIAN * (row + 1) + i] - w * jacobian[JACOBIAN * row + i]) / length;
            }
            addSquare(c, stiffness[row] * bound[c] / length, across, 0);
        }
        double turn = bias[row + 2] - stiffness[row + 2] * speed[row + 2];
        if (Math.abs(turn) <= turnBound(c)) {
            addSquare(c, stiffness[row + 2], jacobian, JACOBIAN * (row + 2));
        }
    }

    /** Adds k j jᵀ for a row j. */
    private void addSquare(int c, double k, double[] j, int at) {
        double[] m = matrix.values();
        int a = nodeA[c];
        int b = nodeB[c];
        if (a >= 0) {
            addProduct(m, matrix.diagonal(a), k, j, at, at, true);
        }
        if (b >= 0) {
            addProduct(m, matrix.diagonal(b), k, j, at + 6, at + 6, true);
        }
        if (a >= 0 && b >= 0) {
            boolean rowsOfA = matrix.hasRowsOf(a, b);
            addProduct(m, matrix.between(a, b), k, j, rowsOfA ? at : at + 6, rowsOfA ? at + 6 : at, false);
        }
    }

    private static void addProduct(double[] m, int to, double k, double[] j, int left, int right, boolean lowerOnly) {
        for (int i = 0; i < 6; i++) {
            double factor = k * j[left + i];
            int end = lowerOnly ? i + 1 : 6;
            for (int l = 0; l < end; l++) {
                m[to + 6 * i + l] += factor * j[right + l];
            }
        }
    }

    private double slope0;
    private double curvature0;
    private final double[] stepMomentum = new double[6 * BlockCholesky.MOST_NODES];
    private final double[] zero = new double[6 * BlockCholesky.MOST_NODES];

    /** Prepares {@link #slope} along a change of the velocities. */
    void along(double[] step) {
        multiply(step, change);
        slope0 = 0;
        curvature0 = 0;
        for (int node = 0; node < nodes; node++) {
            momentum(node, step, zero, stepMomentum);
        }
        for (int i = 0; i < 6 * nodes; i++) {
            slope0 += stepMomentum[i] * (velocity[i] - free[i]);
            curvature0 += stepMomentum[i] * step[i];
        }
    }

    /** Curvature at the share that {@link #slope} was last asked about. */
    double curvature;

    /** Derivative of the function at a share of the step. */
    double slope(double share) {
        double slope = slope0 + share * curvature0;
        curvature = curvature0;
        for (int c = 0; c < manifolds; c++) {
            int friction = firstRow[c] + points(c);
            for (int row = firstRow[c]; row < friction; row++) {
                double d = change[row];
                double pressed = bias[row] - stiffness[row] * (speed[row] + share * d - target[row]);
                if (pressed > 0) {
                    slope -= pressed * d;
                    curvature += stiffness[row] * d * d;
                }
            }
            slope -= frictionSlope(c, friction, share);
        }
        return slope;
    }

    private double frictionSlope(int c, int row, double share) {
        if (bound[c] == 0) {
            return 0;
        }
        double k = stiffness[row];
        double du = change[row];
        double dw = change[row + 1];
        double u = bias[row] - k * (speed[row] + share * du);
        double w = bias[row + 1] - k * (speed[row + 1] + share * dw);
        double length = Math.sqrt(u * u + w * w);
        double scale = length > bound[c] ? bound[c] / length : 1;
        if (scale == 1) {
            curvature += k * (du * du + dw * dw);
        } else {
            double side = (u * dw - w * du) / length;
            curvature += k * scale * side * side;
        }
        double dt = change[row + 2];
        double most = turnBound(c);
        double turn = bias[row + 2] - stiffness[row + 2] * (speed[row + 2] + share * dt);
        if (Math.abs(turn) <= most) {
            curvature += stiffness[row + 2] * dt * dt;
        } else {
            turn = turn < 0 ? -most : most;
        }
        return scale * (u * du + w * dw) + turn * dt;
    }

    /** Goes a share of the step. */
    void go(double[] step, double share) {
        for (int i = 0; i < 6 * nodes; i++) {
            velocity[i] += share * step[i];
        }
        for (int row = 0; row < rows; row++) {
            speed[row] += share * change[row];
        }
    }
}
