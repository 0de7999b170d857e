package nephele.engine.render.gl;

import java.util.EnumMap;
import java.util.Map;

/** How many objects of each kind exist in one context: closing a level must bring every count back. */
public final class LiveObjects {
    private final int[] counts = new int[GlKind.values().length];

    void opened(GlKind kind) {
        counts[kind.ordinal()]++;
    }

    void closed(GlKind kind) {
        counts[kind.ordinal()]--;
    }

    /** A copy, for comparing before and after. */
    public Map<GlKind, Integer> counts() {
        Map<GlKind, Integer> copy = new EnumMap<>(GlKind.class);
        for (GlKind kind : GlKind.values()) {
            copy.put(kind, counts[kind.ordinal()]);
        }
        return copy;
    }
}
