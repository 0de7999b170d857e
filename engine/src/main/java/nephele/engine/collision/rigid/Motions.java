package nephele.engine.collision.rigid;

import java.util.Arrays;

/**
 * What the solver changes: for every body, every character and, last, the static world, six doubles of velocity (linear,
 * angular) and six of displacement since the tick began, with reciprocal masses in world axes.
 */
final class Motions {
    double[] velocity = new double[0];
    double[] moved = new double[0];
    double[] inverseMass = new double[0];
    /** Symmetric: xx, xy, xz, yy, yz, zz. */
    double[] inverseInertia = new double[0];

    int count;

    void resize(int slots) {
        count = slots;
        if (inverseMass.length < slots) {
            velocity = new double[6 * slots];
            moved = new double[6 * slots];
            inverseMass = new double[slots];
            inverseInertia = new double[6 * slots];
        }
        Arrays.fill(velocity, 0, 6 * slots, 0);
        Arrays.fill(moved, 0, 6 * slots, 0);
        Arrays.fill(inverseMass, 0, slots, 0);
        Arrays.fill(inverseInertia, 0, 6 * slots, 0);
    }

    /** R diag(i) Rᵀ for the axes R of a body. */
    void turnInertia(int slot, double[] axes, int at, double iX, double iY, double iZ) {
        int k = 6 * slot;
        if (iX == iY && iY == iZ) {
            inverseInertia[k] = iX;
            inverseInertia[k + 1] = 0;
            inverseInertia[k + 2] = 0;
            inverseInertia[k + 3] = iX;
            inverseInertia[k + 4] = 0;
            inverseInertia[k + 5] = iX;
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
        inverseInertia[k] = iX * xx * xx + iY * yx * yx + iZ * zx * zx;
        inverseInertia[k + 1] = iX * xx * xy + iY * yx * yy + iZ * zx * zy;
        inverseInertia[k + 2] = iX * xx * xz + iY * yx * yz + iZ * zx * zz;
        inverseInertia[k + 3] = iX * xy * xy + iY * yy * yy + iZ * zy * zy;
        inverseInertia[k + 4] = iX * xy * xz + iY * yy * yz + iZ * zy * zz;
        inverseInertia[k + 5] = iX * xz * xz + iY * yz * yz + iZ * zz * zz;
    }
}
