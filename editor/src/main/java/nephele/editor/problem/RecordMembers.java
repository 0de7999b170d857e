package nephele.editor.problem;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Written;

/** Reads and changes members of level records by their names, for every record that there is or will be. */
final class RecordMembers {
    private RecordMembers() {}

    /** Returns a member; {@code null} if the record has none of this name. */
    static Object get(Record record, String name) {
        RecordComponent component = component(record, name);
        return component == null ? null : value(record, component);
    }

    static boolean has(Record record, String name) {
        return component(record, name) != null;
    }

    /** Returns a copy with one member changed. */
    @SuppressWarnings("unchecked")
    static <R extends Record> R with(R record, String name, Object value) {
        RecordComponent[] components = record.getClass().getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < components.length; i++) {
            values[i] = components[i].getName().equals(name) ? value : value(record, components[i]);
        }
        return (R) made(record, components, values);
    }

    /** Returns a copy without the references to records of a section that are not known; the same if there are none. */
    static Object withoutReferences(Object value, String section, Set<String> known) {
        if (value instanceof Record record) {
            return withoutReferences(record, section, known);
        } else if (value instanceof List<?> list) {
            List<Object> kept = new ArrayList<>();
            list.forEach(each -> kept.add(withoutReferences(each, section, known)));
            return kept;
        } else if (value instanceof Map<?, ?> map) {
            Map<Object, Object> kept = new LinkedHashMap<>();
            map.forEach((key, each) -> kept.put(key, withoutReferences(each, section, known)));
            return kept;
        }
        return value;
    }

    private static Record withoutReferences(Record record, String section, Set<String> known) {
        RecordComponent[] components = record.getClass().getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < components.length; i++) {
            Object value = value(record, components[i]);
            boolean isDropped = refersTo(components[i], section) && !known.contains(value);
            values[i] = isDropped ? null : withoutReferences(value, section, known);
        }
        return made(record, components, values);
    }

    /** Adds the ids of a section's records that a value refers to. */
    static void collectReferences(Object value, String section, Set<String> found) {
        if (value instanceof Record record) {
            for (RecordComponent component : record.getClass().getRecordComponents()) {
                Object member = value(record, component);
                if (refersTo(component, section) && member instanceof String id) {
                    found.add(id);
                }
                collectReferences(member, section, found);
            }
        } else if (value instanceof List<?> list) {
            list.forEach(each -> collectReferences(each, section, found));
        } else if (value instanceof Map<?, ?> map) {
            map.values().forEach(each -> collectReferences(each, section, found));
        }
    }

    private static boolean refersTo(RecordComponent component, String section) {
        Written written = component.getAnnotation(Written.class);
        return written != null && written.refersTo().equals(section);
    }

    private static RecordComponent component(Record record, String name) {
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            if (component.getName().equals(name)) {
                return component;
            }
        }
        return null;
    }

    private static Object value(Record record, RecordComponent component) {
        try {
            return component.getAccessor().invoke(record);
        } catch (IllegalAccessException | InvocationTargetException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static Record made(Record like, RecordComponent[] components, Object[] values) {
        Class<?>[] types = new Class<?>[components.length];
        for (int i = 0; i < components.length; i++) {
            types[i] = components[i].getType();
        }
        try {
            return (Record) like.getClass().getDeclaredConstructor(types).newInstance(values);
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
