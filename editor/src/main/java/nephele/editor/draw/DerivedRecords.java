package nephele.editor.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.engine.math.IdentityDiff;

/**
 * Derives a list from another one, element by element. Elements that an edit kept give the same objects as before.
 *
 * @param <A> what it follows from
 * @param <B> what follows
 */
final class DerivedRecords<A, B> {
    private final Function<A, B> derive;
    private List<A> before = List.of();
    private List<B> derived = List.of();

    DerivedRecords(Function<A, B> derive) {
        this.derive = derive;
    }

    /** Returns the derived list, the same object if all elements are. */
    List<B> of(List<A> now) {
        if (now == before) {
            return derived;
        }
        int[] places = IdentityDiff.previousIndices(before, now);
        List<B> all = new ArrayList<>(places.length);
        for (int i = 0; i < places.length; i++) {
            all.add(places[i] == IdentityDiff.NEW ? derive.apply(now.get(i)) : derived.get(places[i]));
        }
        before = now;
        derived = IdentityDiff.list(derived, all);
        return derived;
    }
}
