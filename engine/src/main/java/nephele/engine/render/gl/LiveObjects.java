package nephele.engine.render.gl;

import java.util.EnumMap;
import java.util.Map;

/** The number of objects of each kind in one context, and the size of its textures; closing a level must restore both. */
public final class LiveObjects {
    private final int[] counts = new int[GlKind.values().length];
    private long textureBytes;

    void opened(GlKind kind) {
        counts[kind.ordinal()]++;
    }

    void closed(GlKind kind) {
        counts[kind.ordinal()]--;
    }

    /** @param bytes less than 0 where storage is freed */
    void stored(long bytes) {
        textureBytes += bytes;
    }

    /** Returns the storage of all textures, without what a driver adds to them. */
    public long textureBytes() {
        return textureBytes;
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
