package nephele.engine.collision.rigid;

/**
 * The 64-bit key of a manifold: its two shapes, the portal between them, the touching features and the number of
 * points.
 */
final class ContactKey {
    private static final int FEATURE_BITS = 11;

    private ContactKey() {}

    /** @param collider index in the world of the owner */
    static long withSolid(int owner, int collider) {
        return (((long) owner << 33) | ((long) (collider & 0xffffff) << 8)) << FEATURE_BITS;
    }

    /** @param portal through which the contact acts, or −1 */
    static long between(int a, int b, int portal) {
        return (((long) a << 33) | (1L << 32) | ((long) (b & 0xffffff) << 8) | ((portal + 1) & 0xff)) << FEATURE_BITS;
    }

    static long with(long parties, int code, int points) {
        return parties | ((long) (code & 0xff) << 3) | points;
    }

    static long parties(long key) {
        return key >>> FEATURE_BITS << FEATURE_BITS;
    }

    static boolean sameFeatures(long a, long b) {
        return ((a ^ b) & 0x7f8) == 0;
    }

    static int points(long key) {
        return (int) (key & 7);
    }

    static int first(long key) {
        return (int) (key >>> 33 + FEATURE_BITS);
    }

    /** Returns the solid's index in its world, for a key with a solid. */
    static int solid(long key) {
        return (int) (key >>> 8 + FEATURE_BITS & 0xffffff);
    }

    /** Returns the second owner, or −1 for a solid. */
    static int second(long key) {
        long parties = key >>> FEATURE_BITS;
        return (parties & (1L << 32)) == 0 ? -1 : (int) (parties >>> 8 & 0xffffff);
    }
}
