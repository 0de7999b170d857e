package nephele.engine.collision.rigid.solver;

import java.util.Arrays;
import nephele.engine.collision.rigid.contact.Manifold;

/**
 * The constraint rows of contacts for the solver, in flat arrays. A manifold has up to four rows along its normal, one
 * for each point, and three friction rows at their middle: two tangents and one rotation about the normal, bounded
 * together by the normal impulse (patch friction as in Tamis 2015 and Jolt). Directions are stored for each body in its
 * own space, so that a contact across a portal is a row like any other; a body in contact with itself has one row with
 * both ends joined.
 */
public final class ContactRows {
    public static final int HEAD = 60;
    static final int N_A = 0;
    static final int N_B = 3;
    static final int U_A = 6;
    static final int U_B = 9;
    static final int W_A = 12;
    static final int W_B = 15;
    /** For each tangent: angular parts of a and b, then both multiplied by the inverse inertia. */
    static final int U_ANGULAR = 18;

    static final int W_ANGULAR = 30;
    static final int TWIST = 42;
    static final int MASS = 48;
    public static final int FRICTION_IMPULSE = 51;
    public static final int FRICTION = 54;
    static final int TWIST_RADIUS = 55;
    public static final int RESTITUTION = 56;
    /** Index of the overlap in metres that is not corrected, so that contacts persist. */
    public static final int SLOP = 57;

    public static final int ROW = 17;
    /** Arm × normal of both owners, then both multiplied by the inverse inertia. */
    static final int ANGULAR_A = 0;

    static final int ANGULAR_B = 3;
    static final int TURNED_A = 6;
    static final int TURNED_B = 9;
    static final int ROW_MASS = 12;
    public static final int IMPULSE = 13;
    static final int GAP = 14;
    static final int APPROACH = 15;
    public static final int GREATEST = 16;

    public int count;
    public int[] slotA = new int[64];
    public int[] slotB = new int[64];
    public int[] first = new int[64];
    public int[] points = new int[64];
    public long[] key = new long[64];
    public int[] features = new int[64];
    public double[] head = new double[64 * HEAD];
    public double[] rows = new double[256 * ROW];
    int rowCount;

    private final SolverState motions;
    private final double[] arm = new double[6];

    public ContactRows(SolverState motions) {
        this.motions = motions;
    }

    public void clear() {
        count = 0;
        rowCount = 0;
    }

    private void reserve() {
        if (count == slotA.length) {
            int capacity = 2 * count;
            slotA = Arrays.copyOf(slotA, capacity);
            slotB = Arrays.copyOf(slotB, capacity);
            first = Arrays.copyOf(first, capacity);
            points = Arrays.copyOf(points, capacity);
            key = Arrays.copyOf(key, capacity);
            features = Arrays.copyOf(features, capacity);
            head = Arrays.copyOf(head, capacity * HEAD);
        }
        if ((rowCount + Manifold.MOST) * ROW > rows.length) {
            rows = Arrays.copyOf(rows, 2 * rows.length);
        }
    }

    /**
     * Adds the rows of a manifold between two owners.
     *
     * @param offset centre of the second shape minus that of the first
     * @param turn nine numbers that rotate directions from the space of the second shape's owner into this one
     * (columns), or {@code null} if the spaces are the same
     * @return the number of the manifold
     */
    public int add(Manifold manifold, int a, int b, double[] offset, double[] turn) {
        reserve();
        int m = count++;
        slotA[m] = a;
        slotB[m] = b;
        first[m] = rowCount;
        points[m] = manifold.count;
        features[m] = manifold.features();
        int h = HEAD * m;
        write(h + N_A, manifold.nX, manifold.nY, manifold.nZ);
        tangents(h);
        direction(h + N_A, h + N_B, turn);
        direction(h + U_A, h + U_B, turn);
        direction(h + W_A, h + W_B, turn);
        boolean self = a == b;
        double cX = 0;
        double cY = 0;
        double cZ = 0;
        for (int i = 0; i < manifold.count; i++) {
            cX += manifold.point[3 * i] / manifold.count;
            cY += manifold.point[3 * i + 1] / manifold.count;
            cZ += manifold.point[3 * i + 2] / manifold.count;
            arms(manifold.point[3 * i], manifold.point[3 * i + 1], manifold.point[3 * i + 2], offset, turn);
            int r = ROW * rowCount++;
            double mass = angular(h + N_A, h + N_B, rows, r + ANGULAR_A, m);
            rows[r + ROW_MASS] = mass;
            rows[r + IMPULSE] = 0;
            rows[r + GAP] = manifold.separation[i];
            rows[r + GREATEST] = 0;
        }
        arms(cX, cY, cZ, offset, turn);
        head[h + MASS] = angular(h + U_A, h + U_B, head, h + U_ANGULAR, m);
        head[h + MASS + 1] = angular(h + W_A, h + W_B, head, h + W_ANGULAR, m);
        twist(h, m);
        head[h + TWIST_RADIUS] = meanDistance(manifold, cX, cY, cZ);
        Arrays.fill(head, h + FRICTION_IMPULSE, h + FRICTION_IMPULSE + 3, 0);
        if (self) {
            join(h);
            slotB[m] = motions.count - 1;
        }
        return m;
    }

    private void write(int at, double x, double y, double z) {
        head[at] = x;
        head[at + 1] = y;
        head[at + 2] = z;
    }

    /** Writes two unit directions perpendicular to the normal: the first also to the world axis farthest from it. */
    private void tangents(int h) {
        double x = head[h + N_A];
        double y = head[h + N_A + 1];
        double z = head[h + N_A + 2];
        double aX = Math.abs(x);
        double aY = Math.abs(y);
        double aZ = Math.abs(z);
        if (aX <= aY && aX <= aZ) {
            double length = Math.sqrt(y * y + z * z);
            write(h + U_A, 0, z / length, -y / length);
        } else if (aZ <= aY) {
            double length = Math.sqrt(x * x + y * y);
            write(h + U_A, y / length, -x / length, 0);
        } else {
            double length = Math.sqrt(x * x + z * z);
            write(h + U_A, -z / length, 0, x / length);
        }
        double uX = head[h + U_A];
        double uY = head[h + U_A + 1];
        double uZ = head[h + U_A + 2];
        write(h + W_A, y * uZ - z * uY, z * uX - x * uZ, x * uY - y * uX);
    }

    /** Writes the direction at {@code from}, converted to the second owner's space. */
    private void direction(int from, int to, double[] turn) {
        double x = head[from];
        double y = head[from + 1];
        double z = head[from + 2];
        if (turn == null) {
            write(to, x, y, z);
        } else {
            write(
                    to,
                    turn[0] * x + turn[1] * y + turn[2] * z,
                    turn[3] * x + turn[4] * y + turn[5] * z,
                    turn[6] * x + turn[7] * y + turn[8] * z);
        }
    }

    /** Computes the vectors from the owners' centres to a point, each in its own space. */
    private void arms(double x, double y, double z, double[] offset, double[] turn) {
        arm[0] = x;
        arm[1] = y;
        arm[2] = z;
        double bX = x - offset[0];
        double bY = y - offset[1];
        double bZ = z - offset[2];
        if (turn == null) {
            arm[3] = bX;
            arm[4] = bY;
            arm[5] = bZ;
        } else {
            arm[3] = turn[0] * bX + turn[1] * bY + turn[2] * bZ;
            arm[4] = turn[3] * bX + turn[4] * bY + turn[5] * bZ;
            arm[5] = turn[6] * bX + turn[7] * bY + turn[8] * bZ;
        }
    }

    /**
     * Writes arm × direction of both and their products with the inverse inertia; returns the effective mass of the
     * row.
     */
    private double angular(int dA, int dB, double[] to, int at, int m) {
        cross(0, dA, to, at);
        cross(3, dB, to, at + 3);
        if (slotA[m] == slotB[m]) {
            for (int i = 0; i < 3; i++) {
                to[at + i] -= to[at + 3 + i];
                to[at + 3 + i] = 0;
            }
            turned(slotA[m], to, at, at + 6);
            Arrays.fill(to, at + 9, at + 12, 0);
            double square = 0;
            for (int i = 0; i < 3; i++) {
                double d = head[dA + i] - head[dB + i];
                square += d * d * motions.inverseMass[slotA[m]] + to[at + i] * to[at + 6 + i];
            }
            return square > 1e-12 ? 1 / square : 0;
        }
        turned(slotA[m], to, at, at + 6);
        turned(slotB[m], to, at + 3, at + 9);
        double sum = motions.inverseMass[slotA[m]] + motions.inverseMass[slotB[m]];
        for (int i = 0; i < 6; i++) {
            sum += to[at + i] * to[at + 6 + i];
        }
        return sum > 0 ? 1 / sum : 0;
    }

    private void cross(int from, int direction, double[] to, int at) {
        double x = head[direction];
        double y = head[direction + 1];
        double z = head[direction + 2];
        to[at] = arm[from + 1] * z - arm[from + 2] * y;
        to[at + 1] = arm[from + 2] * x - arm[from] * z;
        to[at + 2] = arm[from] * y - arm[from + 1] * x;
    }

    private void turned(int slot, double[] v, int from, int to) {
        double[] i = motions.inverseInertia;
        int k = SolverState.INERTIA * slot;
        double x = v[from];
        double y = v[from + 1];
        double z = v[from + 2];
        v[to] = i[k] * x + i[k + 1] * y + i[k + 2] * z;
        v[to + 1] = i[k + 1] * x + i[k + 3] * y + i[k + 4] * z;
        v[to + 2] = i[k + 2] * x + i[k + 4] * y + i[k + 5] * z;
    }

    private void twist(int h, int m) {
        turned(slotA[m], head, h + N_A, h + TWIST);
        // N_B is the normal in the second owner's space, which differs from N_A across a portal.
        turned(slotB[m], head, h + N_B, h + TWIST + 3);
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += head[h + N_A + i] * head[h + TWIST + i] + head[h + N_B + i] * head[h + TWIST + 3 + i];
        }
        head[h + MASS + 2] = sum > 0 && slotA[m] != slotB[m] ? 1 / sum : 0;
    }

    /** Joins both ends of every direction, which act on one body. */
    private void join(int h) {
        for (int d = 0; d < 18; d += 6) {
            for (int i = 0; i < 3; i++) {
                head[h + d + i] -= head[h + d + 3 + i];
                head[h + d + 3 + i] = 0;
            }
        }
        Arrays.fill(head, h + TWIST, h + TWIST + 6, 0);
    }

    private static double meanDistance(Manifold manifold, double x, double y, double z) {
        double sum = 0;
        for (int i = 0; i < manifold.count; i++) {
            double dX = manifold.point[3 * i] - x;
            double dY = manifold.point[3 * i + 1] - y;
            double dZ = manifold.point[3 * i + 2] - z;
            sum += Math.sqrt(dX * dX + dY * dY + dZ * dZ);
        }
        return sum / manifold.count;
    }

    /** Returns the speed along a row, positive when the surfaces separate. */
    double partingSpeed(int m, int row) {
        double[] v = motions.velocity;
        int h = HEAD * m;
        int a = SolverState.STRIDE * slotA[m];
        int b = SolverState.STRIDE * slotB[m];
        int r = ROW * row;
        double speed = 0;
        for (int i = 0; i < 3; i++) {
            speed += head[h + N_A + i] * v[a + i]
                    + rows[r + ANGULAR_A + i] * v[a + SolverState.ANGULAR + i]
                    - head[h + N_B + i] * v[b + i]
                    - rows[r + ANGULAR_B + i] * v[b + SolverState.ANGULAR + i];
        }
        return speed;
    }

    /** Stores the approach speeds, for restitution. */
    void rememberApproach() {
        for (int m = 0; m < count; m++) {
            for (int row = first[m]; row < first[m] + points[m]; row++) {
                rows[ROW * row + APPROACH] = partingSpeed(m, row);
            }
        }
    }

    /** Multiplies the impulses of a manifold: to divide a tick's impulse among substeps, or to sum it up again. */
    void scaleImpulses(int m, double factor) {
        for (int i = 0; i < points[m]; i++) {
            rows[ROW * (first[m] + i) + IMPULSE] *= factor;
        }
        for (int i = 0; i < 3; i++) {
            head[HEAD * m + FRICTION_IMPULSE + i] *= factor;
        }
    }

    /** Returns true if a manifold had a normal impulse in this tick. */
    public boolean carries(int m) {
        for (int i = 0; i < points[m]; i++) {
            if (rows[ROW * (first[m] + i) + GREATEST] > 0) {
                return true;
            }
        }
        return false;
    }

    public void writeImpulses(int m, float[] out, int at) {
        for (int i = 0; i < points[m]; i++) {
            out[at + i] = (float) rows[ROW * (first[m] + i) + IMPULSE];
        }
        for (int i = 0; i < 3; i++) {
            out[at + Manifold.MOST + i] = (float) head[HEAD * m + FRICTION_IMPULSE + i];
        }
    }
}
