package nephele.engine.render.gl;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Objects of a context, keyed by the immutable values that they are made from. Equal values share an object; the last
 * holder closes it. So the renderer of an edited level reuses unchanged objects, and several renderers of one scene
 * share its geometry and pictures. Values without OpenGL objects can last longer than their users.
 */
public final class SharedObjects {
    /** Most lasting values; a slider of the editor makes one for each of its positions. */
    static final int MOST_LASTING = 24;

    private final Map<Key, Held> held = new HashMap<>();
    private final Map<Key, Object> lasting = new LinkedHashMap<>(16, 0.75f, true);

    /** A value that equals only itself, for data too large to compare and never created twice. */
    public record Identity(Object value) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Identity identity && identity.value == value;
        }

        @Override
        public int hashCode() {
            return System.identityHashCode(value);
        }
    }

    private record Key(Class<?> kind, Object madeFrom) {}

    private static final class Held {
        private final Object object;
        private final Runnable close;
        private int holders;

        private Held(Object object, Runnable close) {
            this.object = object;
            this.close = close;
        }
    }

    /**
     * Returns an object that is held until {@link #letGo} has been called as often as this.
     *
     * @param madeFrom equal values share an object of the same kind
     * @param make called if nobody holds it
     */
    public <T> T hold(Class<T> kind, Object madeFrom, Supplier<T> make, Consumer<T> close) {
        Key key = new Key(kind, madeFrom);
        if (!held.containsKey(key)) {
            T made = make.get();
            held.put(key, new Held(made, () -> close.accept(made)));
        }
        Held known = held.get(key);
        known.holders++;
        return kind.cast(known.object);
    }

    /** Ends one hold of an object; the last one closes it. */
    public void letGo(Class<?> kind, Object madeFrom) {
        Key key = new Key(kind, madeFrom);
        Held known = held.get(key);
        known.holders--;
        if (known.holders == 0) {
            held.remove(key);
            known.close.run();
        }
    }

    /**
     * Returns a value that is derived again only if {@link #MOST_LASTING} others have been used since. Unlike a held one it stays
     * for the next level when no renderer uses it.
     *
     * @param madeFrom equal values give the same object of the same kind; small, because it is kept
     * @param make derives an immutable value that needs no closing
     */
    public <T> T lasting(Class<T> kind, Object madeFrom, Supplier<T> make) {
        Key key = new Key(kind, madeFrom);
        T value = kind.cast(lasting.get(key));
        if (value == null) {
            value = make.get();
            lasting.put(key, value);
            if (lasting.size() > MOST_LASTING) {
                lasting.remove(lasting.keySet().iterator().next());
            }
        }
        return value;
    }

    /** Returns what is held of a kind, in no particular order. */
    public <T> List<T> all(Class<T> kind) {
        return held.entrySet().stream()
                .filter(entry -> entry.getKey().kind() == kind)
                .map(entry -> kind.cast(entry.getValue().object))
                .toList();
    }
}
