package nephele.engine.collision.rigid.solver;

/**
 * The contacts of one island as a convex function of the bodies' velocities v: half of (v − v₀)ᵀ M (v − v₀), where v₀
 * is the velocity without contacts, plus for each row the energy of a very stiff one-sided spring along a normal, or of
 * one that slips at a bound along a tangent (Castro, Permenter and Han 2022, "An unconstrained convex formulation of
 * compliant contact", with friction bounded as in Tamis 2015). At its minimum, impulses and velocities are consistent.
 * Six doubles a body: linear, angular, world axes. Reused for every island.
 */
final class IslandSystem {
    final IslandRows rows;
    private final SolverState motions;
    private final BlockCholesky matrix;

    int nodes;
    /** The slot of each body in {@link SolverState}. */
    final int[] slot = new int[BlockCholesky.MOST_NODES];

    private final double[] mass = new double[BlockCholesky.MOST_NODES];
    /** World axes, symmetric: xx, xy, xz, yy, yz, zz. */
    private final double[] inertia = new double[SolverState.INERTIA * BlockCholesky.MOST_NODES];

    final double[] free = new double[SolverState.STRIDE * BlockCholesky.MOST_NODES];
    final double[] velocity = new double[SolverState.STRIDE * BlockCholesky.MOST_NODES];
    final double[] gradient = new double[SolverState.STRIDE * BlockCholesky.MOST_NODES];

    /** Impulse of each row, N s. */
    double[] impulse = new double[64];

    private double[] speed = new double[64];
    private double[] change = new double[64];
    private final double[] across = new double[IslandRows.JACOBIAN];

    /** Hash of the rows that are active and those that stick: equal when the function is the same quadratic one. */
    long pattern;

    /** True if a manifold slides: the function is not quadratic there. */
    boolean slides;

    private double slope0;
    private double curvature0;
    private final double[] stepMomentum = new double[SolverState.STRIDE * BlockCholesky.MOST_NODES];
    private final double[] zero = new double[SolverState.STRIDE * BlockCholesky.MOST_NODES];

    /** Curvature at the fraction of the last call of {@link #slope}. */
    double curvature;

    IslandSystem(ContactRows contacts, SolverState motions, BlockCholesky matrix) {
        rows = new IslandRows(contacts);
        this.motions = motions;
        this.matrix = matrix;
    }

    void clear() {
        nodes = 0;
        rows.clear();
    }

    /** Adds a body and returns its number here. */
    int addNode(int itsSlot) {
        int node = nodes++;
        slot[node] = itsSlot;
        mass[node] = 1 / motions.inverseMass[itsSlot];
        System.arraycopy(
                motions.inertia,
                SolverState.INERTIA * itsSlot,
                inertia,
                SolverState.INERTIA * node,
                SolverState.INERTIA);
        rows.keepUpright(node, motions.isUpright(itsSlot));
        return node;
    }

    /** Allocates the values of all rows; must be called after the last manifold has been added. */
    void ready() {
        if (impulse.length < rows.rows) {
            impulse = new double[2 * rows.rows];
            speed = new double[2 * rows.rows];
            change = new double[2 * rows.rows];
        }
    }

    /** Returns a row's last computed speed, positive when the surfaces separate. */
    double speed(int row) {
        return speed[row];
    }

    /** Computes every row's speed from the velocities. */
    void findSpeeds() {
        rows.multiply(velocity, speed);
    }

    /** Computes every row's impulse from its speed. */
    void findImpulses() {
        pattern = 0;
        slides = false;
        for (int c = 0; c < rows.manifolds; c++) {
            int friction = rows.firstRow[c] + rows.points(c);
            for (int row = rows.firstRow[c]; row < friction; row++) {
                impulse[row] = Math.max(0, rows.bias[row] - rows.stiffness[row] * (speed[row] - rows.target[row]));
                pattern = 31 * pattern + (impulse[row] > 0 ? 1 : 0);
            }
            double u = rows.bias[friction] - rows.stiffness[friction] * speed[friction];
            double w = rows.bias[friction + 1] - rows.stiffness[friction + 1] * speed[friction + 1];
            double square = u * u + w * w;
            double scale = square > rows.bound[c] * rows.bound[c] ? rows.bound[c] / Math.sqrt(square) : 1;
            slides |= scale < 1 && rows.bound[c] > 0;
            pattern = 31 * pattern + (scale < 1 ? 1 : 0);
            impulse[friction] = scale * u;
            impulse[friction + 1] = scale * w;
            double most = rows.turnBound(c);
            double turn = rows.bias[friction + 2] - rows.stiffness[friction + 2] * speed[friction + 2];
            impulse[friction + 2] = Math.max(-most, Math.min(most, turn));
            pattern = 31 * pattern + (turn > most ? 1 : turn < -most ? 2 : 0);
        }
    }

    /** Computes the gradient: the momentum relative to the free one, minus the rows' impulses. */
    void findGradient() {
        for (int node = 0; node < nodes; node++) {
            momentum(node, velocity, free, gradient);
        }
        for (int c = 0; c < rows.manifolds; c++) {
            int end = rows.end(c);
            for (int row = rows.firstRow[c]; row < end; row++) {
                if (impulse[row] != 0) {
                    give(row, rows.nodeA[c], rows.nodeB[c], -impulse[row]);
                }
            }
        }
    }

    private void give(int row, int a, int b, double amount) {
        int j = IslandRows.JACOBIAN * row;
        for (int i = 0; a >= 0 && i < SolverState.STRIDE; i++) {
            gradient[SolverState.STRIDE * a + i] += amount * rows.jacobian[j + i];
        }
        for (int i = 0; b >= 0 && i < SolverState.STRIDE; i++) {
            gradient[SolverState.STRIDE * b + i] += amount * rows.jacobian[j + IslandRows.JACOBIAN_B + i];
        }
    }

    /** Multiplies a body's mass matrix by a difference of velocities. */
    private void momentum(int node, double[] v, double[] less, double[] out) {
        int at = SolverState.STRIDE * node;
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

    /** Returns the speed, rotation included, of a body's velocity relative to another one: sqrt(Δvᵀ M Δv / m), m/s. */
    double speedBeyond(int node, double[] other, double factor) {
        for (int i = 0; i < SolverState.STRIDE; i++) {
            zero[SolverState.STRIDE * node + i] = factor * other[SolverState.STRIDE * slot[node] + i];
        }
        momentum(node, velocity, zero, stepMomentum);
        double square = 0;
        for (int i = SolverState.STRIDE * node; i < SolverState.STRIDE * (node + 1); i++) {
            square += stepMomentum[i] * (velocity[i] - zero[i]);
            zero[i] = 0;
        }
        return Math.sqrt(square / mass[node]);
    }

    /** Fills the matrix with the second derivative at the rows' present speeds. */
    void assemble() {
        matrix.clear();
        double[] m = matrix.values();
        for (int node = 0; node < nodes; node++) {
            int d = matrix.diagonal(node);
            int i = SolverState.STRIDE * node;
            for (int axis = 0; axis < 3; axis++) {
                m[d + (BlockCholesky.SIZE + 1) * axis] = mass[node];
            }
            int x = d + BlockCholesky.SIZE * SolverState.ANGULAR + SolverState.ANGULAR;
            int y = x + BlockCholesky.SIZE;
            int z = y + BlockCholesky.SIZE;
            m[x] = inertia[i];
            m[y] = inertia[i + 1];
            m[y + 1] = inertia[i + 3];
            m[z] = inertia[i + 2];
            m[z + 1] = inertia[i + 4];
            m[z + 2] = inertia[i + 5];
        }
        for (int c = 0; c < rows.manifolds; c++) {
            int friction = rows.firstRow[c] + rows.points(c);
            for (int row = rows.firstRow[c]; row < friction; row++) {
                if (rows.bias[row] > rows.stiffness[row] * (speed[row] - rows.target[row])) {
                    addSquare(c, rows.stiffness[row], rows.jacobian, IslandRows.JACOBIAN * row);
                }
            }
            assembleFriction(c, friction);
        }
    }

    private void assembleFriction(int c, int row) {
        if (rows.bound[c] == 0) {
            return;
        }
        double u = rows.bias[row] - rows.stiffness[row] * speed[row];
        double w = rows.bias[row + 1] - rows.stiffness[row + 1] * speed[row + 1];
        double length = Math.sqrt(u * u + w * w);
        if (length <= rows.bound[c]) {
            addSquare(c, rows.stiffness[row], rows.jacobian, IslandRows.JACOBIAN * row);
            addSquare(c, rows.stiffness[row + 1], rows.jacobian, IslandRows.JACOBIAN * (row + 1));
        } else {
            for (int i = 0; i < IslandRows.JACOBIAN; i++) {
                across[i] = (u * rows.jacobian[IslandRows.JACOBIAN * (row + 1) + i]
                                - w * rows.jacobian[IslandRows.JACOBIAN * row + i])
                        / length;
            }
            addSquare(c, rows.stiffness[row] * rows.bound[c] / length, across, 0);
        }
        double turn = rows.bias[row + 2] - rows.stiffness[row + 2] * speed[row + 2];
        if (Math.abs(turn) <= rows.turnBound(c)) {
            addSquare(c, rows.stiffness[row + 2], rows.jacobian, IslandRows.JACOBIAN * (row + 2));
        }
    }

    /** Adds k j jᵀ for a row j. */
    private void addSquare(int c, double k, double[] j, int at) {
        double[] m = matrix.values();
        int a = rows.nodeA[c];
        int b = rows.nodeB[c];
        if (a >= 0) {
            addProduct(m, matrix.diagonal(a), k, j, at, at, true);
        }
        if (b >= 0) {
            addProduct(m, matrix.diagonal(b), k, j, at + IslandRows.JACOBIAN_B, at + IslandRows.JACOBIAN_B, true);
        }
        if (a >= 0 && b >= 0) {
            boolean rowsOfA = matrix.hasRowsOf(a, b);
            addProduct(
                    m,
                    matrix.between(a, b),
                    k,
                    j,
                    rowsOfA ? at : at + IslandRows.JACOBIAN_B,
                    rowsOfA ? at + IslandRows.JACOBIAN_B : at,
                    false);
        }
    }

    private static void addProduct(double[] m, int to, double k, double[] j, int left, int right, boolean lowerOnly) {
        for (int i = 0; i < SolverState.STRIDE; i++) {
            double factor = k * j[left + i];
            int end = lowerOnly ? i + 1 : 6;
            for (int l = 0; l < end; l++) {
                m[to + BlockCholesky.SIZE * i + l] += factor * j[right + l];
            }
        }
    }

    /** Prepares {@link #slope} along a change of the velocities. */
    void along(double[] step) {
        rows.multiply(step, change);
        slope0 = 0;
        curvature0 = 0;
        for (int node = 0; node < nodes; node++) {
            momentum(node, step, zero, stepMomentum);
        }
        for (int i = 0; i < SolverState.STRIDE * nodes; i++) {
            slope0 += stepMomentum[i] * (velocity[i] - free[i]);
            curvature0 += stepMomentum[i] * step[i];
        }
    }

    /** Returns the derivative of the function at a fraction of the step. */
    double slope(double fraction) {
        double slope = slope0 + fraction * curvature0;
        curvature = curvature0;
        for (int c = 0; c < rows.manifolds; c++) {
            int friction = rows.firstRow[c] + rows.points(c);
            for (int row = rows.firstRow[c]; row < friction; row++) {
                double d = change[row];
                double pressed = rows.bias[row] - rows.stiffness[row] * (speed[row] + fraction * d - rows.target[row]);
                if (pressed > 0) {
                    slope -= pressed * d;
                    curvature += rows.stiffness[row] * d * d;
                }
            }
            slope -= frictionSlope(c, friction, fraction);
        }
        return slope;
    }

    private double frictionSlope(int c, int row, double fraction) {
        if (rows.bound[c] == 0) {
            return 0;
        }
        double k = rows.stiffness[row];
        double du = change[row];
        double dw = change[row + 1];
        double u = rows.bias[row] - k * (speed[row] + fraction * du);
        double w = rows.bias[row + 1] - k * (speed[row + 1] + fraction * dw);
        double length = Math.sqrt(u * u + w * w);
        double scale = length > rows.bound[c] ? rows.bound[c] / length : 1;
        if (scale == 1) {
            curvature += k * (du * du + dw * dw);
        } else {
            double side = (u * dw - w * du) / length;
            curvature += k * scale * side * side;
        }
        double dt = change[row + 2];
        double most = rows.turnBound(c);
        double turn = rows.bias[row + 2] - rows.stiffness[row + 2] * (speed[row + 2] + fraction * dt);
        if (Math.abs(turn) <= most) {
            curvature += rows.stiffness[row + 2] * dt * dt;
        } else {
            turn = turn < 0 ? -most : most;
        }
        return scale * (u * du + w * dw) + turn * dt;
    }

    /** Applies a fraction of the step. */
    void go(double[] step, double fraction) {
        for (int i = 0; i < SolverState.STRIDE * nodes; i++) {
            velocity[i] += fraction * step[i];
        }
        for (int row = 0; row < rows.rows; row++) {
            speed[row] += fraction * change[row];
        }
    }
}
