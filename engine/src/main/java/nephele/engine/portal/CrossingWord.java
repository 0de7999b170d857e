package nephele.engine.portal;

import java.util.Arrays;
import nephele.engine.math.BitHash;

/**
 * Which portals lie between two places, in order, with every there-and-back taken out: a reduced word of the free group
 * whose letters are the portals and whose inverses are their partners. A value.
 */
public final class CrossingWord {
    public static final CrossingWord EMPTY = new CrossingWord(new int[0]);

    private final int[] entries;

    private CrossingWord(int[] entries) {
        this.entries = entries;
    }

    public int length() {
        return entries.length;
    }

    /** The portal that is entered at a place of the word. */
    public int entry(int place) {
        return entries[place];
    }

    /** Goes on into {@code portal}; into the partner of the last one it goes back. */
    public CrossingWord then(int portal, Portals portals) {
        int last = entries.length - 1;
        if (last >= 0 && portals.partner(entries[last]) == portal) {
            return last == 0 ? EMPTY : new CrossingWord(Arrays.copyOf(entries, last));
        }
        int[] longer = Arrays.copyOf(entries, last + 2);
        longer[last + 1] = portal;
        return new CrossingWord(longer);
    }

    /** The word from here when the place it begins at has itself gone through {@code portal}. */
    public CrossingWord afterEntering(int portal, Portals portals) {
        if (entries.length > 0 && entries[0] == portal) {
            return entries.length == 1 ? EMPTY : new CrossingWord(Arrays.copyOfRange(entries, 1, entries.length));
        }
        int[] longer = new int[entries.length + 1];
        longer[0] = portals.partner(portal);
        System.arraycopy(entries, 0, longer, 1, entries.length);
        return new CrossingWord(longer);
    }

    /** Joins its length and its letters to a hash. */
    public long hash(long before) {
        long hash = BitHash.join(before, (long) entries.length);
        for (int entry : entries) {
            hash = BitHash.join(hash, (long) entry);
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
