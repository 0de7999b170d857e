package nephele.engine.level;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;

/**
 * Copies records with some components changed, which are given by name. It is for records that change when somebody edits
 * or chooses, not for those of a frame or a tick.
 */
public final class RecordCopy {
    private static final ClassValue<RecordComponent[]> COMPONENTS = new ClassValue<>() {
        @Override
        protected RecordComponent[] computeValue(Class<?> type) {
            RecordComponent[] components = type.getRecordComponents();
            Arrays.stream(components)
                    .forEach(component -> component.getAccessor().setAccessible(true));
            return components;
        }
    };

    private static final ClassValue<Constructor<?>> CONSTRUCTORS = new ClassValue<>() {
        @Override
        protected Constructor<?> computeValue(Class<?> type) {
            Class<?>[] types = Arrays.stream(COMPONENTS.get(type))
                    .map(RecordComponent::getType)
                    .toArray(Class<?>[]::new);
            try {
                Constructor<?> constructor = type.getDeclaredConstructor(types);
                constructor.setAccessible(true);
                return constructor;
            } catch (NoSuchMethodException e) {
                throw new IllegalStateException(e);
            }
        }
    };

    private RecordCopy() {}

    /**
     * Returns a copy of a record in which the named components have other values.
     *
     * @param changes names of components, each followed by its value; a whole number may stand for a {@code double}
     * @throws IllegalArgumentException if the record has no component of a name or it cannot hold the value, and what the
     *     record's own constructor throws
     */
    public static <R extends Record> R with(R record, Object... changes) {
        RecordComponent[] components = COMPONENTS.get(record.getClass());
        try {
            Object[] values = new Object[components.length];
            for (int i = 0; i < values.length; i++) {
                values[i] = components[i].getAccessor().invoke(record);
            }
            for (int i = 0; i < changes.length; i += 2) {
                values[index(components, (String) changes[i])] = changes[i + 1];
            }
            @SuppressWarnings("unchecked")
            Class<R> type = (Class<R>) record.getClass();
            return of(type, values);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Returns a record of these values, which are in the order of its components.
     *
     * @throws IllegalArgumentException if a component cannot hold its value, and what the record's own constructor throws
     */
    public static <R extends Record> R of(Class<R> type, Object... values) {
        try {
            return type.cast(CONSTRUCTORS.get(type).newInstance(values));
        } catch (InvocationTargetException e) {
            throw e.getCause() instanceof RuntimeException refused ? refused : new IllegalStateException(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private static int index(RecordComponent[] components, String name) {
        for (int i = 0; i < components.length; i++) {
            if (components[i].getName().equals(name)) {
                return i;
            }
        }
        throw new IllegalArgumentException(
                components[0].getDeclaringRecord().getSimpleName() + " has no component " + name);
    }
}
