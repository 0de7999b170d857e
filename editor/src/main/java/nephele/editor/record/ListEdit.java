package nephele.editor.record;

import java.util.ArrayList;
import java.util.List;

/**
 * One entry of a list removed, inserted or moved, and where the others are afterwards.
 *
 * @param from the entry's index before, {@link #NONE} if it is new
 * @param to its index after, {@link #NONE} if it is gone
 */
public record ListEdit(int from, int to) {
    /** The index of an entry that is not in the list. */
    public static final int NONE = -1;

    public static ListEdit removed(int index) {
        return new ListEdit(index, NONE);
    }

    public static ListEdit moved(int from, int to) {
        return new ListEdit(from, to);
    }

    /** The new entry is a copy of the one before which it stands. */
    public static ListEdit inserted(int index) {
        return new ListEdit(NONE, index);
    }

    /** Returns the list after the edit; the same object if it has not the entries that the edit needs. */
    public List<?> on(List<?> list) {
        if (Math.max(from, to) >= list.size()) {
            return list;
        }
        List<Object> entries = new ArrayList<>(list);
        Object entry = from == NONE ? list.get(to) : entries.remove(from);
        if (to != NONE) {
            entries.add(to, entry);
        }
        return List.copyOf(entries);
    }

    /** Returns the index after the edit of what had an index before, {@link #NONE} if it is gone. */
    public int after(int index) {
        if (index == from) {
            return to;
        }
        int without = from != NONE && index > from ? index - 1 : index;
        return to != NONE && without >= to ? without + 1 : without;
    }
}
