package nephele.engine.scene.probe;

import java.util.Arrays;
import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Ray;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.scene.light.bake.Occluders;

/**
 * The light on dynamic objects by direction; the counterpart of the light map. The visible fractions of the sky around
 * each axis, weighted by the cosine, and where light was baked also the radiance of the static geometry around, are
 * computed at points of a lattice on first use and interpolated between those lattice points that are visible from the
 * position. The result depends on the position only, except for points that {@link #begin} defers.
 */
public final class SkyProbes {
    /** Visible fractions of the sky at a position: +x, +y, +z, −x, −y, −z. */
    public static final int VALUES = 6;

    /** Values at a position where light was baked: after the fractions, for each of their axes red, green and blue. */
    public static final int LIT_VALUES = 4 * VALUES;

    /** Faces of levels are at whole and half metres; no lattice point should be in them. */
    private static final double OFFSET_METRES = 0.137;

    private static final float INSIDE = -1;
    private static final int NONE = -1;

    /**
     * So many lattice points are computed in a frame before others wait. A walk needs four for each plane of the lattice, whose
     * weights grow from nothing; these take tenths of a millisecond each.
     */
    private static final int POINTS_EACH_FRAME = 2;

    /**
     * Places around a lattice point, in units of the lattice: some on a sphere, then others between these. How many of them
     * are visible decides how visible the point is, so that nothing changes suddenly; if all or none of those on the sphere
     * are, the others are as well.
     */
    private static final double[][] AROUND = around();

    private static final double AROUND_SHARE = 0.25;
    private static final int AROUND_COUNT = Long.SIZE;
    private static final int ON_SPHERE = 14;

    /** The sum of weights below which the place itself is computed and takes the rest. */
    private static final double FEW = 0.125;

    private final StaticShapes statics;
    private final Supplier<LitSurfaces> light;
    /** Made on the first lookup, as the following. */
    private Occluders occluders;
    /** {@code null} where no light was baked. */
    private LitSurfaces surfaces;

    /** Values of a lattice point: the fractions, then for each axis red, green and blue of each layer of light. */
    private int values;

    private Map<String, Double> gains = Map.of();
    /** The gain of each layer of {@link #surfaces}. */
    private double[] gainOf;

    private long version;
    private final double metres;
    private final double[][] directions;
    private final double[] from = new double[3];
    private final double[] displacement = new double[3];
    private final Ray ray = Ray.reusable();
    private final RayHit hit = new RayHit();
    private double[] sums;
    private double[] rgb;
    private final double[] all = new double[VALUES];
    /** Values as of a lattice point: at the position itself, and interpolated. */
    private float[] here;

    private float[] mixed;
    private final ItemRayTest meets;
    private long[] keys = new long[256];
    private float[] known;
    /** The places around each lattice point that are visible from it, a bit each; {@code null} where no light was baked. */
    private long[] freeAround;

    private int size;
    private int pointsLeft = Integer.MAX_VALUE;
    private boolean isCut = true;
    private boolean isComplete;

    /**
     * How finely the light around is sampled.
     *
     * @param metres spacing of the lattice
     * @param rays of a lattice point
     */
    public record Sampling(double metres, int rays) {
        public static final Sampling USUAL = new Sampling(0.5, 192);

        /** Enough where walls send no light. */
        private static final Sampling OF_SKY = new Sampling(0.5, 96);

        /** Returns the usual sampling with another spacing. */
        public static Sampling every(double metres) {
            return new Sampling(metres, USUAL.rays);
        }
    }

    /** Makes the probes of a level without baked light. */
    public SkyProbes(StaticShapes statics) {
        this(statics, null, Sampling.OF_SKY);
    }

    /**
     * Makes the probes of a level with baked light.
     *
     * @param light called on the first lookup; {@code null} without baked light
     */
    public SkyProbes(StaticShapes statics, Supplier<LitSurfaces> light, Sampling sampling) {
        this.statics = statics;
        this.light = light;
        metres = sampling.metres();
        directions = evenly(sampling.rays());
        freeAround = light == null ? null : new long[keys.length];
        meets = (sight, item, limit) -> occluders.hit(item, from, displacement, limit);
        Arrays.fill(keys, Long.MIN_VALUE);
    }

    private static double[][] around() {
        double[][] around = Arrays.copyOf(evenly(ON_SPHERE), AROUND_COUNT);
        double[][] others = evenly(AROUND_COUNT - ON_SPHERE);
        for (int i = 0; i < others.length; i++) {
            // Within the solid whose corners are those on the sphere.
            double radius = 0.7 * Math.cbrt((i + 0.5) * (Math.sqrt(5) - 1) / 2 % 1);
            around[ON_SPHERE + i] = new double[] {radius * others[i][0], radius * others[i][1], radius * others[i][2]};
        }
        for (double[] place : around) {
            for (int axis = 0; axis < 3; axis++) {
                place[axis] *= AROUND_SHARE;
            }
        }
        return around;
    }

    /** Returns unit directions evenly over the sphere (Vogel 1979). */
    public static double[][] evenly(int count) {
        double[][] directions = new double[count][];
        for (int i = 0; i < count; i++) {
            double y = 1 - (2 * i + 1.0) / count;
            double radius = Math.sqrt(1 - y * y);
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            directions[i] = new double[] {radius * Math.cos(angle), y, radius * Math.sin(angle)};
        }
        return directions;
    }

    /** Returns the number of values at a position: {@link #VALUES}, or {@link #LIT_VALUES} where light was baked. */
    public int values() {
        return light == null ? VALUES : LIT_VALUES;
    }

    /** Returns a number that changes when the same position has other values than before. */
    public long version() {
        return version;
    }

    /**
     * Begins a frame: few of the lattice points that its lookups lack are computed, unless it is the first after a cut.
     *
     * @param layerGains by the names of layers of light; 1 for others
     */
    public void begin(Map<String, Double> layerGains) {
        if (!layerGains.equals(gains)) {
            gains = layerGains;
            gainOf = null;
            version++;
        }
        pointsLeft = isCut || light == null ? Integer.MAX_VALUE : POINTS_EACH_FRAME;
        isCut = false;
    }

    /** Makes the next frame compute all that it lacks. */
    public void cut() {
        isCut = true;
    }

    /**
     * Writes the values at a position from {@code out[at]} on.
     *
     * @return false if a lattice point was left out that a later frame computes
     */
    public boolean at(double x, double y, double z, float[] out, int at) {
        prepare();
        isComplete = true;
        double weights = mix(x, y, z, true);
        if (surfaces != null && weights < FEW) {
            from[0] = x;
            from[1] = y;
            from[2] = z;
            if (!occluders.isInside(from, -1)) {
                gather(here, 0);
                double share = weights / FEW;
                for (int value = 0; value < values; value++) {
                    mixed[value] = (float) (share * mixed[value] + (1 - share) * here[value]);
                }
                weights = 1;
            }
        }
        if (weights == 0) {
            // No lattice point is visible from inside a solid; then all free ones nearby are used.
            mix(x, y, z, false);
        }
        write(mixed, out, at);
        return isComplete;
    }

    /** Writes the values at a position without a lattice, as {@link #at}. */
    public void exactly(double x, double y, double z, float[] out, int at) {
        prepare();
        from[0] = x;
        from[1] = y;
        from[2] = z;
        gather(here, 0);
        write(here, out, at);
    }

    private void prepare() {
        if (occluders == null) {
            surfaces = light == null ? null : light.get();
            occluders = surfaces == null ? new Occluders(statics) : surfaces.occluders();
            int layers = surfaces == null ? 0 : surfaces.names().size();
            values = VALUES + 3 * layers * VALUES;
            rgb = new double[3 * layers];
            sums = new double[values];
            here = new float[values];
            mixed = new float[values];
            known = new float[keys.length * values];
        }
        if (surfaces != null && gainOf == null) {
            gainOf = surfaces.names().stream()
                    .mapToDouble(name -> gains.getOrDefault(name, 1.0))
                    .toArray();
        }
    }

    /** Writes values of a lattice point with the layers of its light added up. */
    private void write(float[] point, float[] out, int at) {
        System.arraycopy(point, 0, out, at, VALUES);
        for (int i = 0; i < 3 * VALUES && surfaces != null; i++) {
            double sum = 0;
            for (int layer = 0; layer < gainOf.length; layer++) {
                sum += gainOf[layer] * point[VALUES + rgb.length * (i / 3) + 3 * layer + i % 3];
            }
            out[at + VALUES + i] = (float) sum;
        }
    }

    /**
     * Interpolates the values into {@link #mixed}.
     *
     * @param onlyVisible whether to leave out the lattice points that are not visible from the position
     * @return the sum of the weights of the lattice points that were used
     */
    private double mix(double x, double y, double z, boolean onlyVisible) {
        double weights = 0;
        double cellX = (x - OFFSET_METRES) / metres;
        double cellY = (y - OFFSET_METRES) / metres;
        double cellZ = (z - OFFSET_METRES) / metres;
        int nearest = surfaces == null ? 0 : upper(cellX) + 2 * upper(cellY) + 4 * upper(cellZ);
        Arrays.fill(mixed, 0);
        for (int number = 0; number < 8; number++) {
            int corner = number ^ nearest;
            double i = Math.floor(cellX) + (corner & 1);
            double j = Math.floor(cellY) + (corner >> 1 & 1);
            double k = Math.floor(cellZ) + (corner >> 2);
            double weight = (1 - Math.abs(cellX - i)) * (1 - Math.abs(cellY - j)) * (1 - Math.abs(cellZ - k));
            int place = weight < 1e-3 ? NONE : placeOf((int) i, (int) j, (int) k);
            if (place == NONE || known[values * place] == INSIDE) {
                continue;
            }
            if (onlyVisible) {
                weight *= seen(x, y, z, i, j, k, place);
            }
            weights += weight;
            for (int value = 0; value < values && weight > 0; value++) {
                mixed[value] += (float) (weight * known[values * place + value]);
            }
        }
        for (int value = 0; value < values && weights > 0; value++) {
            mixed[value] /= (float) weights;
        }
        return weights;
    }

    private static int upper(double cell) {
        return cell - Math.floor(cell) >= 0.5 ? 1 : 0;
    }

    /** Returns how much of a lattice point is visible from a position: 0 or 1, where light was baked also between. */
    private double seen(double x, double y, double z, double i, double j, double k, int place) {
        from[0] = x;
        from[1] = y;
        from[2] = z;
        if (surfaces == null) {
            return sees(i, j, k) ? 1 : 0;
        }
        long free = freeAround[place];
        int seen = 0;
        int tested = 0;
        for (int number = 0; number < AROUND.length; number++) {
            boolean isOneKind = seen == 0 || seen == tested;
            if (number == ON_SPHERE && tested > 0 && isOneKind) {
                return seen == 0 ? 0 : Long.bitCount(free) / (double) AROUND.length;
            }
            if ((free >> number & 1) != 0) {
                tested++;
                seen += sees(i + AROUND[number][0], j + AROUND[number][1], k + AROUND[number][2]) ? 1 : 0;
            }
        }
        return seen / (double) AROUND.length;
    }

    /** Returns true if nothing is between {@link #from} and a place in units of the lattice. */
    private boolean sees(double i, double j, double k) {
        displacement[0] = i * metres + OFFSET_METRES - from[0];
        displacement[1] = j * metres + OFFSET_METRES - from[1];
        displacement[2] = k * metres + OFFSET_METRES - from[2];
        ray.aim(from[0], from[1], from[2], displacement[0], displacement[1], displacement[2]);
        return !occluders.anyHit(ray, 1, meets);
    }

    /** Returns the place of a lattice point's values, which are computed on first use; {@link #NONE} if that has to wait. */
    private int placeOf(int i, int j, int k) {
        long key = (i & 0x1fffffL) << 42 | (j & 0x1fffffL) << 21 | k & 0x1fffffL;
        int place = place(key);
        if (keys[place] == key) {
            return place;
        }
        if (pointsLeft == 0) {
            isComplete = false;
            return NONE;
        }
        pointsLeft--;
        if (2 * ++size > keys.length) {
            grow();
            place = place(key);
        }
        keys[place] = key;
        find(i, j, k, place);
        return place;
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
        long[] oldFree = freeAround;
        keys = new long[2 * oldKeys.length];
        known = new float[2 * old.length];
        freeAround = oldFree == null ? null : new long[keys.length];
        Arrays.fill(keys, Long.MIN_VALUE);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldKeys[i] != Long.MIN_VALUE) {
                int place = place(oldKeys[i]);
                keys[place] = oldKeys[i];
                System.arraycopy(old, values * i, known, values * place, values);
                if (oldFree != null) {
                    freeAround[place] = oldFree[i];
                }
            }
        }
    }

    private void find(int i, int j, int k, int place) {
        from[0] = i * metres + OFFSET_METRES;
        from[1] = j * metres + OFFSET_METRES;
        from[2] = k * metres + OFFSET_METRES;
        if (occluders.isInside(from, -1)) {
            known[values * place] = INSIDE;
            return;
        }
        for (int number = 0; number < AROUND.length && surfaces != null; number++) {
            boolean isFree = sees(i + AROUND[number][0], j + AROUND[number][1], k + AROUND[number][2]);
            freeAround[place] |= isFree ? 1L << number : 0;
        }
        gather(known, values * place);
    }

    /** Writes the values at {@link #from}. */
    private void gather(float[] out, int at) {
        Arrays.fill(sums, 0);
        Arrays.fill(all, 0);
        for (double[] d : directions) {
            System.arraycopy(d, 0, displacement, 0, 3);
            ray.aim(from[0], from[1], from[2], d[0], d[1], d[2]);
            boolean isHit = surfaces == null
                    ? occluders.anyHit(ray, Double.MAX_VALUE, meets)
                    : occluders.nearest(ray, Double.MAX_VALUE, meets, hit);
            if (isHit && surfaces != null) {
                int face = occluders.faceOf(hit.item(), from, displacement);
                surfaces.leaving(hit.item(), face, ray.at(hit.distance()), rgb);
            }
            for (int axis = 0; axis < 3; axis++) {
                int value = d[axis] >= 0 ? axis : axis + 3;
                double weight = Math.abs(d[axis]);
                all[value] += weight;
                sums[value] += isHit ? 0 : weight;
                for (int i = 0; i < rgb.length && isHit; i++) {
                    sums[VALUES + rgb.length * value + i] += weight * rgb[i];
                }
            }
        }
        for (int value = 0; value < values; value++) {
            out[at + value] = (float) (sums[value] / all[value < VALUES ? value : (value - VALUES) / rgb.length]);
        }
    }
}
