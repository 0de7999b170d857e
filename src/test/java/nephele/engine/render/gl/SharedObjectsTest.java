package nephele.engine.render.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** How long objects of a context last. */
class SharedObjectsTest {
    private final SharedObjects shared = new SharedObjects();
    private final List<Long> made = new ArrayList<>();

    private Object lasting(long from) {
        return shared.lasting(Object.class, from, () -> {
            made.add(from);
            return new Object();
        });
    }

    @Test
    void anObjectEndsWithItsLastHolder() {
        List<String> closed = new ArrayList<>();
        Object first = shared.hold(Object.class, "key", Object::new, object -> closed.add("closed"));
        Object second = shared.hold(Object.class, "key", Object::new, object -> closed.add("closed"));
        assertSame(first, second);
        shared.letGo(Object.class, "key");
        assertEquals(List.of(), closed);
        shared.letGo(Object.class, "key");
        assertEquals(List.of("closed"), closed);
    }

    @Test
    void aLastingValueIsDerivedOnceForEqualKeysAndApartForEachKind() {
        Object one = lasting(1);
        assertSame(one, lasting(1));
        assertNotSame(one, lasting(2));
        assertEquals("text", shared.lasting(String.class, 1L, () -> "text"));
        assertSame(one, lasting(1));
        assertEquals(List.of(1L, 2L), made);
    }

    /** A full cache drops its least recently used value for a new one. */
    @Test
    void theLeastRecentlyUsedLastingValueGoesFirst() {
        for (long i = 0; i < SharedObjects.MOST_LASTING; i++) {
            lasting(i);
        }
        lasting(0);
        lasting(-1);
        made.clear();
        lasting(0);
        lasting(2);
        assertEquals(List.of(), made);
        lasting(1);
        assertEquals(List.of(1L), made);
    }
}
