package nephele.engine.collision.rigid;

import nephele.engine.math.BitHash;

/**
 * The contact cache: impulses of a tick's contacts, for warm starting (Catto 2005). One entry for each manifold: the
 * two shapes, the features of its points and the impulses in N s – up to four along the normal, two along the tangents
 * – and one angular impulse about the normal in N m s. Immutable.
 */
final class ContactMemory {
    static final ContactMemory NONE = new ContactMemory(new long[0], new int[0], new float[0], 1);

    /** Number of impulses of an entry. */
    static final int IMPULSES = 7;

    private final long[] keys;
    private final int[] features;
    private final float[] impulses;
    private final double seconds;

    /** @param seconds length of the step that produced the impulses */
    ContactMemory(long[] keys, int[] features, float[] impulses, double seconds) {
        this.seconds = seconds;
        this.keys = keys;
        this.features = features;
        this.impulses = impulses;
    }

    int size() {
        return keys.length;
    }

    long key(int entry) {
        return keys[entry];
    }

    int features(int entry) {
        return features[entry];
    }

    float impulse(int entry, int row) {
        return impulses[IMPULSES * entry + row];
    }

    /** Returns the factor that converts these impulses to a step of another length. */
    double scaleTo(double nowSeconds) {
        return nowSeconds / seconds;
    }

    /** Copies the impulses of an entry, converted to a step of another length. */
    void copyImpulses(int entry, double nowSeconds, float[] out, int outEntry) {
        double scale = scaleTo(nowSeconds);
        for (int i = 0; i < IMPULSES; i++) {
            out[IMPULSES * outEntry + i] = (float) (scale * impulses[IMPULSES * entry + i]);
        }
    }

    long hash(long before) {
        long hash = BitHash.join(before, (long) keys.length);
        for (int i = 0; i < keys.length; i++) {
            hash = BitHash.join(BitHash.join(hash, keys[i]), features[i]);
        }
        hash = keys.length == 0 ? hash : BitHash.join(hash, seconds);
        for (float impulse : impulses) {
            hash = BitHash.join(hash, Float.floatToIntBits(impulse));
        }
        return hash;
    }
}
