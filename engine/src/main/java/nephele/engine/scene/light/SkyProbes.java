package nephele.engine.scene.light;

import java.util.Arrays;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.scene.light.bake.Occluders;

/**
 * The sky visibility of dynamic objects by direction; the counterpart of the light map. The visible fractions of the
 * directions around each axis, weighted by the cosine, are computed at points of a lattice on first use and
 * interpolated between those lattice points that are visible from the position. The result depends on the position
 * only.
 */
public final class SkyProbes {
    /** Values at a position: +x, +y, +z, −x, −y, −z. */
    public static final int VALUES = 6;

    private static final double SPACING_METRES = 0.5;
    /** Faces of levels are at whole and half metres; no lattice point should be in them. */
    private static final double OFFSET_METRES = 0.137;

    private static final int DIRECTIONS = 96;
    private static final float INSIDE = -1;

    private final StaticShapes statics;
    /** Made on the first lookup. */
    private Occluders occluders;

    private final double[][] directions = new double[DIRECTIONS][];
    private final double[] from = new double[3];
    private final double[] displacement = new double[3];
    private final Ray ray = Ray.reusable();
    private final double[] open = new double[VALUES];
    private final double[] all = new double[VALUES];
    private final ItemRayTest meets;
    private long[] keys = new long[256];
    private float[] known = new float[256 * VALUES];
    private int size;

    public SkyProbes(StaticShapes statics) {
        this.statics = statics;
        meets = (sight, item, limit) -> occluders.hit(item, from, displacement, limit);
        for (int i = 0; i < DIRECTIONS; i++) {
            // Evenly over the sphere (Vogel 1979).
            double y = 1 - (2 * i + 1.0) / DIRECTIONS;
            double radius = Math.sqrt(1 - y * y);
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            directions[i] = new double[] {radius * Math.cos(angle), y, radius * Math.sin(angle)};
        }
        Arrays.fill(keys, Long.MIN_VALUE);
    }

    /** Writes the visible fractions of the sky at a position, each 0 to 1, from {@code out[at]} on. */
    public void at(double x, double y, double z, float[] out, int at) {
        occluders = occluders == null ? new Occluders(statics) : occluders;
        // No lattice point is visible from inside a solid; then all free ones nearby are used.
        if (!mix(x, y, z, true, out, at)) {
            mix(x, y, z, false, out, at);
        }
    }

    /**
     * Interpolates the values.
     *
     * @param onlyVisible whether to leave out the lattice points that are not visible from the position
     * @return true if any lattice point around the position was used
     */
    private boolean mix(double x, double y, double z, boolean onlyVisible, float[] out, int at) {
        double weights = 0;
        double cellX = (x - OFFSET_METRES) / SPACING_METRES;
        double cellY = (y - OFFSET_METRES) / SPACING_METRES;
        double cellZ = (z - OFFSET_METRES) / SPACING_METRES;
        Arrays.fill(out, at, at + VALUES, 0);
        for (int corner = 0; corner < 8; corner++) {
            double i = Math.floor(cellX) + (corner & 1);
            double j = Math.floor(cellY) + (corner >> 1 & 1);
            double k = Math.floor(cellZ) + (corner >> 2);
            double weight = (1 - Math.abs(cellX - i)) * (1 - Math.abs(cellY - j)) * (1 - Math.abs(cellZ - k));
            int slot = slot((int) i, (int) j, (int) k);
            if (known[slot] == INSIDE || weight < 1e-3) {
                continue;
            }
            if (onlyVisible && !sees(x, y, z, i, j, k)) {
                continue;
            }
            weights += weight;
            for (int value = 0; value < VALUES; value++) {
                out[at + value] += (float) (weight * known[slot + value]);
            }
        }
        for (int value = 0; value < VALUES && weights > 0; value++) {
            out[at + value] /= (float) weights;
        }
        return weights > 0;
    }

    private boolean sees(double x, double y, double z, double i, double j, double k) {
        from[0] = x;
        from[1] = y;
        from[2] = z;
        displacement[0] = i * SPACING_METRES + OFFSET_METRES - x;
        displacement[1] = j * SPACING_METRES + OFFSET_METRES - y;
        displacement[2] = k * SPACING_METRES + OFFSET_METRES - z;
        return !occluders.anyHit(ray.aim(x, y, z, displacement[0], displacement[1], displacement[2]), 1, meets);
    }

    /** Returns the index in {@link #known} of a lattice point's values; computes them on first use. */
    private int slot(int i, int j, int k) {
        long key = (i & 0x1fffffL) << 42 | (j & 0x1fffffL) << 21 | k & 0x1fffffL;
        int place = place(key);
        if (keys[place] != key) {
            if (2 * ++size > keys.length) {
                grow();
                place = place(key);
            }
            keys[place] = key;
            find(i, j, k, VALUES * place);
        }
        return VALUES * place;
    }

    private int place(long key) {
        int place = (int) (key * 0x9e3779b97f4a7c15L >>> 40) & keys.length - 1;
        while (keys[place] != key && keys[place] != Long.MIN_VALUE) {
            place = place + 1 & keys.length - 1;
        }
        return place;
    }

    private void grow() {
        long[] oldKeys = keys;
        float[] old = known;
        keys = new long[2 * oldKeys.length];
        known = new float[2 * old.length];
        Arrays.fill(keys, Long.MIN_VALUE);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldKeys[i] != Long.MIN_VALUE) {
                int place = place(oldKeys[i]);
                keys[place] = oldKeys[i];
                System.arraycopy(old, VALUES * i, known, VALUES * place, VALUES);
            }
        }
    }

    private void find(int i, int j, int k, int at) {
        from[0] = i * SPACING_METRES + OFFSET_METRES;
        from[1] = j * SPACING_METRES + OFFSET_METRES;
        from[2] = k * SPACING_METRES + OFFSET_METRES;
        if (occluders.isInside(from, -1)) {
            known[at] = INSIDE;
            return;
        }
        Arrays.fill(open, 0);
        Arrays.fill(all, 0);
        for (double[] d : directions) {
            System.arraycopy(d, 0, displacement, 0, 3);
            ray.aim(from[0], from[1], from[2], d[0], d[1], d[2]);
            double visible = occluders.anyHit(ray, Double.MAX_VALUE, meets) ? 0 : 1;
            for (int axis = 0; axis < 3; axis++) {
                int value = d[axis] >= 0 ? axis : axis + 3;
                all[value] += Math.abs(d[axis]);
                open[value] += visible * Math.abs(d[axis]);
            }
        }
        for (int value = 0; value < VALUES; value++) {
            known[at + value] = (float) (open[value] / all[value]);
        }
    }
}
