package nephele.engine.collision.rigid.body;

import java.util.Arrays;
import org.joml.Vector3d;

/**
 * The poses of all shapes of a tick: the bodies, then the characters, then images of both beyond portals, then one
 * scratch place for a static box. Flat arrays, because hundreds are read in every tick.
 */
public final class Poses {
    /** Numbers of {@link #axes} for each shape. */
    public static final int AXES = 9;
    /** Numbers of {@link #bounds} for each shape. */
    public static final int BOUNDS = 6;

    public int count;
    /** {@link BodyTable#SPHERE}, {@link BodyTable#CAPSULE} or {@link BodyTable#BOX}. */
    public int[] kind = new int[0];

    /** The owner of the motion that a contact changes: index of a body, or of a character after the bodies. */
    public int[] owner = new int[0];
    /** The portal that maps an image (the one on which its owner is active), or −1. */
    public int[] through = new int[0];

    public double[] centre = new double[0];
    /** The directions of the shape's axes: x, y, z of each. */
    public double[] axes = new double[0];

    public double[] half = new double[0];
    /** Least and greatest coordinates, grown by the possible motion in the tick. */
    public double[] bounds = new double[0];

    public void clear() {
        count = 0;
    }

    public int add(int itsKind, int itsOwner, int itsPortal) {
        if (count == kind.length) {
            grow(Math.max(16, 2 * count));
        }
        kind[count] = itsKind;
        owner[count] = itsOwner;
        through[count] = itsPortal;
        return count++;
    }

    private void grow(int capacity) {
        kind = Arrays.copyOf(kind, capacity);
        owner = Arrays.copyOf(owner, capacity);
        through = Arrays.copyOf(through, capacity);
        centre = Arrays.copyOf(centre, 3 * capacity);
        axes = Arrays.copyOf(axes, AXES * capacity);
        half = Arrays.copyOf(half, 3 * capacity);
        bounds = Arrays.copyOf(bounds, BOUNDS * capacity);
    }

    /** Sets {@code out} to the centre of a shape and returns it. */
    public Vector3d centre(int shape, Vector3d out) {
        return out.set(centre[3 * shape], centre[3 * shape + 1], centre[3 * shape + 2]);
    }

    public void place(int shape, double x, double y, double z) {
        centre[3 * shape] = x;
        centre[3 * shape + 1] = y;
        centre[3 * shape + 2] = z;
    }

    public void halves(int shape, double x, double y, double z) {
        half[3 * shape] = x;
        half[3 * shape + 1] = y;
        half[3 * shape + 2] = z;
    }

    /** Sets the axes from a unit quaternion. */
    public void turn(int shape, double x, double y, double z, double w) {
        int at = AXES * shape;
        axes[at] = 1 - 2 * (y * y + z * z);
        axes[at + 1] = 2 * (x * y + w * z);
        axes[at + 2] = 2 * (x * z - w * y);
        axes[at + 3] = 2 * (x * y - w * z);
        axes[at + 4] = 1 - 2 * (x * x + z * z);
        axes[at + 5] = 2 * (y * z + w * x);
        axes[at + 6] = 2 * (x * z + w * y);
        axes[at + 7] = 2 * (y * z - w * x);
        axes[at + 8] = 1 - 2 * (x * x + y * y);
    }

    public void upright(int shape) {
        turn(shape, 0, 0, 0, 1);
    }

    /** Returns the half extent of the shape along a world axis. */
    public double extent(int shape, int axis) {
        int h = 3 * shape;
        int a = AXES * shape + axis;
        if (kind[shape] == BodyTable.BOX) {
            return half[h] * Math.abs(axes[a])
                    + half[h + 1] * Math.abs(axes[a + 3])
                    + half[h + 2] * Math.abs(axes[a + 6]);
        }
        return half[h + 1] * Math.abs(axes[a + 3]) + half[h + 2];
    }

    /**
     * Sets bounds that contain the shape during a displacement, with a margin.
     *
     * @param turned displacement in metres of its farthest point by rotation
     */
    public void bound(
            int shape, double displacementX, double displacementY, double displacementZ, double turned, double margin) {
        bound(shape, 0, displacementX, turned, margin);
        bound(shape, 1, displacementY, turned, margin);
        bound(shape, 2, displacementZ, turned, margin);
    }

    private void bound(int shape, int axis, double path, double turned, double margin) {
        double still = extent(shape, axis);
        double reach = Math.max(still, Math.min(still + turned, radius(shape))) + margin;
        double c = centre[3 * shape + axis];
        bounds[BOUNDS * shape + axis] = c - reach + Math.min(0, path);
        bounds[BOUNDS * shape + 3 + axis] = c + reach + Math.max(0, path);
    }

    public boolean overlap(int a, int b) {
        int i = BOUNDS * a;
        int j = BOUNDS * b;
        return bounds[i] <= bounds[j + 3]
                && bounds[j] <= bounds[i + 3]
                && bounds[i + 1] <= bounds[j + 4]
                && bounds[j + 1] <= bounds[i + 4]
                && bounds[i + 2] <= bounds[j + 5]
                && bounds[j + 2] <= bounds[i + 5];
    }

    /** Returns half of the shape's least thickness. */
    public double leastHalf(int shape) {
        return kind[shape] == BodyTable.BOX
                ? Math.min(half[3 * shape], Math.min(half[3 * shape + 1], half[3 * shape + 2]))
                : half[3 * shape + 2];
    }

    /** Returns the radius of the bounding sphere around the centre. */
    public double radius(int shape) {
        double x = half[3 * shape];
        double y = half[3 * shape + 1];
        double z = half[3 * shape + 2];
        return kind[shape] == BodyTable.BOX ? Math.sqrt(x * x + y * y + z * z) : y + z;
    }
}
