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
    private static final ClassValue<Form> FORMS = new ClassValue<>() {
        @Override
        protected Form computeValue(Class<?> type) {
            return Form.of(type);
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
        Form form = FORMS.get(record.getClass());
        try {
            Object[] values = new Object[form.components.length];
            for (int i = 0; i < values.length; i++) {
                values[i] = form.components[i].getAccessor().invoke(record);
            }
            for (int i = 0; i < changes.length; i += 2) {
                values[form.index((String) changes[i])] = changes[i + 1];
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
            return type.cast(FORMS.get(type).constructor.newInstance(values));
        } catch (InvocationTargetException e) {
            throw e.getCause() instanceof RuntimeException refused ? refused : new IllegalStateException(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private record Form(RecordComponent[] components, Constructor<?> constructor) {
        static Form of(Class<?> type) {
            var components = type.getRecordComponents();
            Arrays.stream(components)
                    .forEach(component -> component.getAccessor().setAccessible(true));
            Class<?>[] types =
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
            try {
                var constructor = type.getDeclaredConstructor(types);
                constructor.setAccessible(true);
                return new Form(components, constructor);
            } catch (NoSuchMethodException e) {
                throw new IllegalStateException(e);
            }
        }

        int index(String name) {
            for (int i = 0; i < components.length; i++) {
                if (components[i].getName().equals(name)) {
                    return i;
                }
            }
            throw new IllegalArgumentException(
                    constructor.getDeclaringClass().getSimpleName() + " has no component " + name);
        }
    }
}
