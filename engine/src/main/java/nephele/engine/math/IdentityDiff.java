package nephele.engine.math;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Compares two versions of a list by object identity, to find the elements that an edit kept. */
public final class IdentityDiff {
    /** The index reported for a new object. */
    public static final int NEW = -1;

    private IdentityDiff() {}

    /**
     * Returns for each element of {@code now} the index of the same object in {@code before}, or {@link #NEW}. Only the
     * elements between the first and the last change are hashed.
     */
    public static int[] previousIndices(List<?> before, List<?> now) {
        int[] places = new int[now.size()];
        int most = Math.min(before.size(), now.size());
        int first = 0;
        while (first < most && before.get(first) == now.get(first)) {
            places[first] = first;
            first++;
        }
        int shift = now.size() - before.size();
        int end = now.size();
        while (end > first && end - shift > first && before.get(end - 1 - shift) == now.get(end - 1)) {
            end--;
            places[end] = end - shift;
        }
        Map<Itself, Integer> between = new LinkedHashMap<>();
        for (int i = first; i < end - shift; i++) {
            between.put(new Itself(before.get(i)), i);
        }
        for (int i = first; i < end; i++) {
            places[i] = between.getOrDefault(new Itself(now.get(i)), NEW);
        }
        return places;
    }

    /** A key that compares by identity. */
    private record Itself(Object object) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Itself itself && itself.object == object;
        }

        @Override
        public int hashCode() {
            // The hash only affects speed, not the order.
            return Objects.hashCode(object);
        }
    }

    /** Returns {@code before} if both lists hold the same objects in the same order, otherwise {@code now}. */
    public static <T> List<T> list(List<T> before, List<T> now) {
        boolean isSame = before.size() == now.size();
        for (int i = 0; i < now.size() && isSame; i++) {
            isSame = before.get(i) == now.get(i);
        }
        return isSame ? before : now;
    }
}
