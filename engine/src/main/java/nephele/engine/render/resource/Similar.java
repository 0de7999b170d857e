package nephele.engine.render.resource;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import nephele.engine.math.heightfield.HeightField;

/** Finds what was made of a field that differs least from another one, as that of the terrain before an edit. */
public final class Similar {
    private Similar() {}

    /** Returns one of those whose field has a grid of the same size; empty if there is none. */
    public static <T> Optional<T> of(List<T> made, Function<T, HeightField> madeFrom, HeightField field) {
        long least = Long.MAX_VALUE;
        T found = null;
        for (T each : made) {
            long samples = field.difference(madeFrom.apply(each))
                    .map(range -> range.count())
                    .orElse(Long.MAX_VALUE);
            if (samples < least) {
                least = samples;
                found = each;
            }
        }
        return Optional.ofNullable(found);
    }
}
