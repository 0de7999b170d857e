package nephele.engine.collision.rigid.solver;

import java.util.Arrays;

/**
 * The solver's state: for every body, every character and, last, the static world, six doubles of velocity (linear,
 * angular) and six of displacement since the tick began, with reciprocal masses in world axes.
 */
public final class SolverState {
    /** Numbers of velocity or displacement for each slot: linear, then angular. */
    public static final int STRIDE = 6;
    /** Offset of the angular part. */
    public static final int ANGULAR = 3;
    /** Numbers of a symmetric matrix for each slot: xx, xy, xz, yy, yz, zz. */
    static final int INERTIA = 6;

    public double[] velocity = new double[0];
    public double[] moved = new double[0];
    public double[] inverseMass = new double[0];
    /** Symmetric: xx, xy, xz, yy, yz, zz. */
    double[] inverseInertia = new double[0];
    /** Moments of inertia in the same layout; a character's are 1, and nothing rotates it. */
    double[] inertia = new double[0];

    public int count;

    public void resize(int slots) {
        count = slots;
        if (inverseMass.length < slots) {
            velocity = new double[STRIDE * slots];
            moved = new double[STRIDE * slots];
            inverseMass = new double[slots];
            inverseInertia = new double[INERTIA * slots];
            inertia = new double[INERTIA * slots];
        }
        Arrays.fill(velocity, 0, STRIDE * slots, 0);
        Arrays.fill(moved, 0, STRIDE * slots, 0);
        Arrays.fill(inverseMass, 0, slots, 0);
        Arrays.fill(inverseInertia, 0, INERTIA * slots, 0);
    }

    /** Sets a slot's inertia from reciprocal moments along the axes of its body. */
    public void turnInertia(int slot, double[] axes, int at, double iX, double iY, double iZ) {
        turn(inverseInertia, INERTIA * slot, axes, at, iX, iY, iZ);
        turn(inertia, INERTIA * slot, axes, at, 1 / iX, 1 / iY, 1 / iZ);
    }

    /** Prevents the rotation of a slot. */
    public void keepUpright(int slot) {
        int k = INERTIA * slot;
        Arrays.fill(inverseInertia, k, k + INERTIA, 0);
        Arrays.fill(inertia, k, k + INERTIA, 0);
        inertia[k] = 1;
        inertia[k + 3] = 1;
        inertia[k + 5] = 1;
    }

    boolean isUpright(int slot) {
        int k = INERTIA * slot;
        return inverseInertia[k] == 0 && inverseInertia[k + 3] == 0 && inverseInertia[k + 5] == 0;
    }

    /** Writes R diag(i) Rᵀ for the axes R of a body. */
    private static void turn(double[] out, int k, double[] axes, int at, double iX, double iY, double iZ) {
        if (iX == iY && iY == iZ) {
            out[k] = iX;
            out[k + 1] = 0;
            out[k + 2] = 0;
            out[k + 3] = iX;
            out[k + 4] = 0;
            out[k + 5] = iX;
            return;
        }
        double xx = axes[at];
        double xy = axes[at + 1];
        double xz = axes[at + 2];
        double yx = axes[at + 3];
        double yy = axes[at + 4];
        double yz = axes[at + 5];
        double zx = axes[at + 6];
        double zy = axes[at + 7];
        double zz = axes[at + 8];
        out[k] = iX * xx * xx + iY * yx * yx + iZ * zx * zx;
        out[k + 1] = iX * xx * xy + iY * yx * yy + iZ * zx * zy;
        out[k + 2] = iX * xx * xz + iY * yx * yz + iZ * zx * zz;
        out[k + 3] = iX * xy * xy + iY * yy * yy + iZ * zy * zy;
        out[k + 4] = iX * xy * xz + iY * yy * yz + iZ * zy * zz;
        out[k + 5] = iX * xz * xz + iY * yz * yz + iZ * zz * zz;
    }
}
