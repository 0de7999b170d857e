package nephele.engine.render.gl;

import java.util.EnumMap;
import java.util.Map;

/** The number of objects of each kind in one context; closing a level must restore every count. */
public final class LiveObjects {
    private final int[] counts = new int[GlKind.values().length];

    void opened(GlKind kind) {
        counts[kind.ordinal()]++;
    }

    void closed(GlKind kind) {
        counts[kind.ordinal()]--;
    }

    /** Returns a copy of the counts, to compare before and after. */
    public Map<GlKind, Integer> counts() {
        Map<GlKind, Integer> copy = new EnumMap<>(GlKind.class);
        for (GlKind kind : GlKind.values()) {
            copy.put(kind, counts[kind.ordinal()]);
        }
        return copy;
    }
}
