package nephele.engine.render.gl;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Objects that end together, the last first; shared ones stay while someone else holds them. Closing twice is harmless. */
public final class OwnedObjects implements GlObject {
    private final GlContext gl;
    private final Deque<GlObject> owned = new ArrayDeque<>();

    public OwnedObjects(GlContext gl) {
        this.gl = gl;
    }

    /** Returns the context of the objects. */
    public GlContext gl() {
        return gl;
    }

    /** Keeps an object until this is closed. */
    public <T extends GlObject> T own(T object) {
        owned.push(object);
        return object;
    }

    /**
     * Returns an object that all holders in the context share if they request it for the same value.
     *
     * @param madeFrom an immutable value from which the object follows
     */
    public <T extends GlObject> T share(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return hold(kind, madeFrom, make, GlObject::close);
    }

    /** Shares a value that needs no closing: derived once for as long as any holder in the context uses it. */
    public <T> T shareValue(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return hold(kind, madeFrom, make, value -> {});
    }

    private <T> T hold(Class<T> kind, Object madeFrom, Supplier<T> make, Consumer<T> close) {
        T object = gl.shared().hold(kind, madeFrom, make, close);
        own(() -> gl.shared().letGo(kind, madeFrom));
        return object;
    }

    /** Returns a value that stays for other levels of the context; see {@link SharedObjects#lasting}. */
    public <T> T lasting(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return gl.shared().lasting(kind, madeFrom, make);
    }

    @Override
    public void close() {
        while (!owned.isEmpty()) {
            owned.pop().close();
        }
    }
}
