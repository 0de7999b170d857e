package nephele.workshop.prove.process;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.NumberRange;
import nephele.engine.level.json.NumberText;
import nephele.engine.level.json.WordFormats;
import nephele.engine.level.json.WrittenField;
import nephele.engine.level.json.WrittenRecord;
import nephele.engine.math.Vec3;

/**
 * The numbers of a level, found by the declarations of its records, and the text of the level with some of them
 * replaced. The text has every key that the level does not lack, those of default values too.
 */
final class LevelNumbers {
    /** A component of a record class. */
    record Component(Class<?> record, WrittenField field) {
        private boolean isWhole() {
            return field.type() == int.class || field.type() == long.class;
        }
    }

    /**
     * A number in the text.
     *
     * @param path as in messages, such as {@code solids[0].size[1]}
     * @param component that holds it, alone or in a vector or a list
     */
    record Place(String path, Component component) {
        /** Returns true if a level may have the number here. */
        boolean permits(double number) {
            return component.field().range().contains(number) && (!component.isWhole() || number == Math.rint(number));
        }

        /**
         * Returns zero, the least and the greatest number, those just beyond them, subnormal ones, and ones that are far
         * outside, each once.
         */
        Set<String> oddNumbers() {
            Set<String> odd = new LinkedHashSet<>(List.of("0", "-0", "5e-324", "-5e-324", "2.2250738585072014e-308"));
            boolean isWhole = component.isWhole();
            for (NumberRange.Stretch stretch : component.field().range().stretches()) {
                odd.add(NumberText.of(stretch.min()));
                odd.add(NumberText.of(stretch.max()));
                odd.add(NumberText.of(isWhole ? stretch.min() - 1 : Math.nextDown(stretch.min())));
                odd.add(NumberText.of(isWhole ? stretch.max() + 1 : Math.nextUp(stretch.max())));
            }
            odd.addAll(List.of("0.5", "9007199254740993", "1e308", "-1e308"));
            return odd;
        }
    }

    private static final Map<Class<?>, WrittenRecord> RECORDS = new HashMap<>();

    private final Level level;
    private final List<Place> places;

    LevelNumbers(Level level) {
        this.level = level;
        Writer writer = new Writer(Map.of());
        writer.level(level);
        places = List.copyOf(writer.places);
    }

    List<Place> places() {
        return places;
    }

    /** Returns the text of the level with the numbers of some places, by their index, replaced. */
    String with(Map<Integer, String> numbers) {
        Writer writer = new Writer(numbers);
        writer.level(level);
        return writer.text.toString();
    }

    private static final class Writer {
        private final Map<Integer, String> instead;
        private final StringBuilder text = new StringBuilder();
        private final List<Place> places = new ArrayList<>();

        Writer(Map<Integer, String> instead) {
            this.instead = instead;
        }

        void level(Level level) {
            text.append("{\"format\": \"nephele-level\", \"version\": 1");
            members(level, "");
            text.append("}\n");
        }

        /** Writes the members of a record after others of its object. */
        private void members(Record owner, String path) {
            WrittenRecord record = RECORDS.computeIfAbsent(owner.getClass(), WrittenRecord::of);
            for (int i = 0; i < record.fields().size(); i++) {
                WrittenField field = record.fields().get(i);
                Object value = record.value(owner, i);
                String name = path.isEmpty() ? field.name() : path + "." + field.name();
                if (field.written().beside()) {
                    kind(field.type(), value, ", ");
                    members((Record) value, path);
                } else if (value != null && !isOnlyAbsent(field, value)) {
                    text.append(", \"").append(field.name()).append("\": ");
                    value(new Component(owner.getClass(), field), field.type(), value, name);
                }
            }
        }

        /** Returns true for the value of an absent key that a file must not state, such as an angle of view of 0. */
        private static boolean isOnlyAbsent(WrittenField field, Object value) {
            return value instanceof Double number
                    && value.equals(field.absent())
                    && !field.range().contains(number);
        }

        private void kind(Type declared, Object value, String after) {
            if (declared instanceof Class<?> type && type.isSealed()) {
                text.append(after)
                        .append("\"kind\": \"")
                        .append(value.getClass().getSimpleName().toLowerCase(Locale.ROOT))
                        .append('"');
            }
        }

        private void value(Component component, Type type, Object value, String path) {
            if (value instanceof Number number) {
                number(component, number.doubleValue(), path);
            } else if (value instanceof Exposure exposure && !exposure.isAuto()) {
                number(component, exposure.fixedStops(), path);
            } else if (value instanceof Vec3 vector) {
                numbers(component, List.of(vector.x(), vector.y(), vector.z()), path);
            } else if (value instanceof List<?> list) {
                list(component, ((ParameterizedType) type).getActualTypeArguments()[0], list, path);
            } else if (value instanceof Map<?, ?> table) {
                table(component, ((ParameterizedType) type).getActualTypeArguments()[1], table, path);
            } else if (value instanceof Enum<?>) {
                quoted(WordFormats.Choice.word(value));
            } else if (value instanceof String || value instanceof Exposure) {
                quoted(value.toString());
            } else if (value instanceof Record record) {
                record(component, type, record, path);
            } else {
                text.append(value);
            }
        }

        private void record(Component component, Type type, Record record, String path) {
            if (component.field().written().array()) {
                tuple(record, path);
                return;
            }
            int start = text.append('{').length();
            kind(type, record, ", ");
            members(record, path);
            if (text.length() > start) {
                text.delete(start, start + 2);
            }
            text.append('}');
        }

        private void tuple(Record record, String path) {
            WrittenRecord written = RECORDS.computeIfAbsent(record.getClass(), WrittenRecord::of);
            text.append('[');
            for (int i = 0; i < written.fields().size(); i++) {
                text.append(i == 0 ? "" : ", ");
                WrittenField field = written.fields().get(i);
                value(
                        new Component(record.getClass(), field),
                        field.type(),
                        written.value(record, i),
                        path + "[" + i + "]");
            }
            text.append(']');
        }

        private void list(Component component, Type type, List<?> list, String path) {
            text.append('[');
            for (int i = 0; i < list.size(); i++) {
                text.append(i == 0 ? "" : ", ");
                value(component, type, list.get(i), path + "[" + i + "]");
            }
            text.append(']');
        }

        private void table(Component component, Type type, Map<?, ?> table, String path) {
            String separator = "";
            text.append('{');
            for (Map.Entry<?, ?> entry : table.entrySet()) {
                String key = entry.getKey() instanceof String name ? name : WordFormats.Choice.word(entry.getKey());
                text.append(separator);
                quoted(key);
                text.append(": ");
                value(component, type, entry.getValue(), path + "." + key);
                separator = ", ";
            }
            text.append('}');
        }

        private void numbers(Component component, List<Double> numbers, String path) {
            list(component, double.class, numbers, path);
        }

        private void number(Component component, double number, String path) {
            text.append(instead.getOrDefault(places.size(), NumberText.of(number)));
            places.add(new Place(path, component));
        }

        private void quoted(String plain) {
            text.append('"')
                    .append(plain.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n"))
                    .append('"');
        }
    }
}
