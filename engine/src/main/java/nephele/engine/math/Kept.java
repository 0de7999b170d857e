package nephele.engine.math;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** What an edit leaves the same: objects that are in the list before it and in the list after it. */
public final class Kept {
    /** The place of an object that is new. */
    public static final int NEW = -1;

    private Kept() {}

    /**
     * For each element of a list where the same object is in the list before, {@link #NEW} where it is not. Takes little
     * longer than what lies between the first and the last change is long.
     */
    public static int[] places(List<?> before, List<?> now) {
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

    /** An object that equals no other. */
    private record Itself(Object object) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Itself itself && itself.object == object;
        }

        @Override
        public int hashCode() {
            // Decides how quickly an object is found, no order.
            return Objects.hashCode(object);
        }
    }

    /** The list before where the other one has the same objects in the same order, else the other one. */
    public static <T> List<T> list(List<T> before, List<T> now) {
        boolean isSame = before.size() == now.size();
        for (int i = 0; i < now.size() && isSame; i++) {
            isSame = before.get(i) == now.get(i);
        }
        return isSame ? before : now;
    }
}
