package nephele.engine.portal;

import java.util.Arrays;
import nephele.engine.math.Hash64;

/**
 * The portals between two places, in order and without any pair that goes through and back: a reduced word of the free
 * group that has the portals as letters and their partners as inverses. {@link #then} and {@link #afterEntering} keep
 * it reduced. A value.
 */
public final class CrossingWord {
    public static final CrossingWord EMPTY = new CrossingWord(new int[0]);

    private final int[] entries;

    private CrossingWord(int[] entries) {
        this.entries = entries;
    }

    /** Returns the number of portals. */
    public int length() {
        return entries.length;
    }

    /** Returns the index of the portal that is entered at a place of the word. */
    public int entry(int place) {
        return entries[place];
    }

    /** Returns the word continued into {@code portal}; shorter if that is the partner of the last one. */
    public CrossingWord then(int portal, Portals portals) {
        int last = entries.length - 1;
        if (last >= 0 && portals.partner(entries[last]) == portal) {
            return last == 0 ? EMPTY : new CrossingWord(Arrays.copyOf(entries, last));
        }
        int[] longer = Arrays.copyOf(entries, last + 2);
        longer[last + 1] = portal;
        return new CrossingWord(longer);
    }

    /**
     * Returns the word from here when the place where it begins has itself gone through {@code portal}; shorter if that
     * is the first one.
     */
    public CrossingWord afterEntering(int portal, Portals portals) {
        if (entries.length > 0 && entries[0] == portal) {
            return entries.length == 1 ? EMPTY : new CrossingWord(Arrays.copyOfRange(entries, 1, entries.length));
        }
        int[] longer = new int[entries.length + 1];
        longer[0] = portals.partner(portal);
        System.arraycopy(entries, 0, longer, 1, entries.length);
        return new CrossingWord(longer);
    }

    /** Joins the length and the letters to a hash. */
    public long hash(long before) {
        long hash = Hash64.combine(before, (long) entries.length);
        for (int entry : entries) {
            hash = Hash64.combine(hash, (long) entry);
        }
        return hash;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof CrossingWord word && Arrays.equals(entries, word.entries);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(entries);
    }

    @Override
    public String toString() {
        return Arrays.toString(entries);
    }
}
