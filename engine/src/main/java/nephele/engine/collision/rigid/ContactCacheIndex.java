package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.rigid.body.ContactCache;
import nephele.engine.collision.rigid.contact.Manifold;
import nephele.engine.collision.rigid.solver.ContactRows;

/** Finds a manifold in the contact cache, and copies its impulses to the rows of the same points. Reused. */
final class ContactCacheIndex {
    private static final int NOTHING = -1;

    private ContactCache memory = ContactCache.NONE;
    private double scale = 1;
    private int[] table = new int[16];
    private int mask = 15;

    /** @param nowSeconds length of the present step: impulses are proportional to time */
    void index(ContactCache last, double nowSeconds) {
        memory = last;
        scale = last.scaleTo(nowSeconds);
        int size = Integer.highestOneBit(Math.max(8, last.size())) * 4;
        if (table.length < size) {
            table = new int[size];
        }
        mask = size - 1;
        Arrays.fill(table, 0, size, NOTHING);
        for (int i = 0; i < last.size(); i++) {
            int at = slot(ContactKey.parties(last.key(i)));
            while (table[at] != NOTHING) {
                at = at + 1 & mask;
            }
            table[at] = i;
        }
    }

    private int slot(long parties) {
        long mixed = parties * 0x9e3779b97f4a7c15L;
        return (int) (mixed >>> 32) & mask;
    }

    private int find(long parties) {
        int at = slot(parties);
        while (table[at] != NOTHING) {
            if (ContactKey.parties(memory.key(table[at])) == parties) {
                return table[at];
            }
            at = at + 1 & mask;
        }
        return NOTHING;
    }

    /** Warm starts the rows of manifold {@code m}. */
    void recall(ContactRows rows, int m) {
        int entry = find(ContactKey.parties(rows.key[m]));
        if (entry == NOTHING || !ContactKey.sameFeatures(memory.key(entry), rows.key[m])) {
            return;
        }
        int known = ContactKey.points(memory.key(entry));
        int features = memory.features(entry);
        int used = 0;
        for (int i = 0; i < rows.points[m]; i++) {
            int wanted = rows.features[m] >>> 8 * i & 0xff;
            for (int j = 0; j < known; j++) {
                if ((used & 1 << j) == 0 && (features >>> 8 * j & 0xff) == wanted) {
                    used |= 1 << j;
                    int r = ContactRows.ROW * (rows.first[m] + i);
                    rows.rows[r + ContactRows.IMPULSE] = scale * memory.impulse(entry, j);
                    rows.rows[r + ContactRows.GREATEST] = scale * memory.impulse(entry, j);
                    break;
                }
            }
        }
        int f = ContactRows.HEAD * m + ContactRows.FRICTION_IMPULSE;
        for (int i = 0; i < 3; i++) {
            rows.head[f + i] = scale * memory.impulse(entry, Manifold.MOST + i);
        }
    }
}
