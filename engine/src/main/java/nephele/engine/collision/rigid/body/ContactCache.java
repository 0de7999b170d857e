package nephele.engine.collision.rigid.body;

import nephele.engine.math.Hash64;

/**
 * The contact cache: impulses of a tick's contacts, for warm starting (Catto 2005). One entry for each manifold: the
 * two shapes, the features of its points and the impulses in N s – up to four along the normal, two along the tangents
 * – and one angular impulse about the normal in N m s. Immutable.
 *
 * <p>A manifold's key has 64 bits: its two shapes, the portal between them, the touching features and the number of
 * points.
 */
public final class ContactCache {
    public static final ContactCache NONE = new ContactCache(new long[0], new int[0], new float[0], 1);

    /** Number of impulses of an entry. */
    public static final int IMPULSES = 7;

    /** Bits of a key below its shapes: eight for the touching features, three for the number of points. */
    private static final int FEATURE_BITS = 11;

    private final long[] keys;
    private final int[] features;
    private final float[] impulses;
    private final double seconds;

    /** @param seconds length of the step that produced the impulses */
    public ContactCache(long[] keys, int[] features, float[] impulses, double seconds) {
        this.seconds = seconds;
        this.keys = keys;
        this.features = features;
        this.impulses = impulses;
    }

    public int size() {
        return keys.length;
    }

    public long key(int entry) {
        return keys[entry];
    }

    public int features(int entry) {
        return features[entry];
    }

    public float impulse(int entry, int row) {
        return impulses[IMPULSES * entry + row];
    }

    /** Returns the factor that converts these impulses to a step of another length. */
    public double scaleTo(double nowSeconds) {
        return nowSeconds / seconds;
    }

    /** Copies the impulses of an entry, converted to a step of another length. */
    public void copyImpulses(int entry, double nowSeconds, float[] out, int outEntry) {
        double scale = scaleTo(nowSeconds);
        for (int i = 0; i < IMPULSES; i++) {
            out[IMPULSES * outEntry + i] = (float) (scale * impulses[IMPULSES * entry + i]);
        }
    }

    long hash(long before) {
        long hash = Hash64.combine(before, (long) keys.length);
        for (int i = 0; i < keys.length; i++) {
            hash = Hash64.combine(Hash64.combine(hash, keys[i]), features[i]);
        }
        hash = keys.length == 0 ? hash : Hash64.combine(hash, seconds);
        for (float impulse : impulses) {
            hash = Hash64.combine(hash, Float.floatToIntBits(impulse));
        }
        return hash;
    }

    /**
     * Returns the part of a key that names its shapes: a body and a solid.
     *
     * @param collider index in the world of the owner
     */
    public static long withSolid(int owner, int collider) {
        return (((long) owner << 33) | ((long) (collider & 0xffffff) << 8)) << FEATURE_BITS;
    }

    /**
     * Returns the part of a key that names its shapes: two bodies or characters.
     *
     * @param portal through which the contact acts, or −1
     */
    public static long between(int a, int b, int portal) {
        return (((long) a << 33) | (1L << 32) | ((long) (b & 0xffffff) << 8) | ((portal + 1) & 0xff)) << FEATURE_BITS;
    }

    /** Returns the whole key: the shapes, the identifier of the touching features and the number of points. */
    public static long key(long parties, int code, int points) {
        return parties | ((long) (code & 0xff) << 3) | points;
    }

    /** Returns the part of a key that names its shapes. */
    public static long parties(long key) {
        return key >>> FEATURE_BITS << FEATURE_BITS;
    }

    /** Returns true if two keys name the same touching features. */
    public static boolean isSameFeatures(long a, long b) {
        return ((a ^ b) & 0x7f8) == 0;
    }

    /** Returns the number of points of a key's manifold. */
    public static int points(long key) {
        return (int) (key & 7);
    }

    /** Returns the first owner of a key. */
    public static int first(long key) {
        return (int) (key >>> 33 + FEATURE_BITS);
    }

    /** Returns the solid's index in its world, for a key with a solid. */
    public static int solid(long key) {
        return (int) (key >>> 8 + FEATURE_BITS & 0xffffff);
    }

    /** Returns the second owner of a key, or −1 for a solid. */
    public static int second(long key) {
        long parties = key >>> FEATURE_BITS;
        return (parties & (1L << 32)) == 0 ? -1 : (int) (parties >>> 8 & 0xffffff);
    }
}
