package nephele.engine.collision.rigid.body;

import nephele.engine.math.Hash64;

/**
 * The contact cache: impulses of a tick's contacts, for warm starting (Catto 2005). One entry for each manifold: the
 * two shapes, the features of its points and the impulses in N s – up to four along the normal, two along the tangents
 * – and one angular impulse about the normal in N m s. Immutable.
 */
public final class ContactCache {
    public static final ContactCache NONE = new ContactCache(new long[0], new int[0], new float[0], 1);

    /** Number of impulses of an entry. */
    public static final int IMPULSES = 7;

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
}
