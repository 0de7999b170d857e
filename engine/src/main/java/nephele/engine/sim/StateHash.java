package nephele.engine.sim;

import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;

/** Joins numbers to a 64-bit hash, in order: the finaliser of SplitMix64 (Steele, Lea and Flood 2014) after each. */
final class StateHash {
    private StateHash() {}

    static long join(long hash, long bits) {
        long z = (hash ^ bits) + 0x9e3779b97f4a7c15L;
        z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }

    /** NaN has one pattern here: its others depend on the processor. */
    static long join(long hash, Vec3 v) {
        long x = join(hash, Double.doubleToLongBits(v.x()));
        return join(join(x, Double.doubleToLongBits(v.y())), Double.doubleToLongBits(v.z()));
    }

    static long join(long hash, CrossingWord word) {
        long joined = join(hash, word.length());
        for (int i = 0; i < word.length(); i++) {
            joined = join(joined, word.entry(i));
        }
        return joined;
    }
}
