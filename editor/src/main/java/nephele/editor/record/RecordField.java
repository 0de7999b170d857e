package nephele.editor.record;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Spatial;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.WrittenField;

/** A component of a record: its name, kind, limits and defaults. */
public record RecordField(int index, WrittenField written, FieldKind kind) {
    /** Symbols of units by the ends of names of components. */
    private static final Map<String, String> UNITS = Map.of(
            "MetresPerSecond", "m/s",
            "PerMetre", "1/m",
            "Metres", "m",
            "Degrees", "°",
            "Kilograms", "kg",
            "Hours", "h",
            "Seconds", "s",
            "Stops", "EV");

    static RecordField of(int index, WrittenField written) {
        return new RecordField(index, written, FieldKind.of(written.type(), written.written()));
    }

    public String name() {
        return written.name();
    }

    /** Returns the declaration: limits, reference, meaning in the world. */
    public Written declaration() {
        return written.written();
    }

    /** Returns the range of its numbers, or of those of its entries; {@code null} if it holds none. */
    public NumberRange range() {
        return written.range();
    }

    public Spatial spatial() {
        return written.written().spatial();
    }

    public boolean isRequired() {
        return written.written().required();
    }

    /** Returns true if the value may be {@code null}: absent in the file and in the record. */
    public boolean isNullable() {
        return !isRequired()
                && !declaration().beside()
                && written.absent() == null
                && !valueClass().isPrimitive();
    }

    /** Returns true for the component that is the record's id. */
    public boolean isId() {
        return name().equals("id") && declaration().text() == TextKind.ID && kind == FieldKind.TEXT;
    }

    /** Returns the class of the value; of a list's elements and a table's values: {@link #elementClass}. */
    public Class<?> valueClass() {
        return FieldKind.rawClass(written.type());
    }

    /** Returns the class of a list's elements or a table's values. */
    public Class<?> elementClass() {
        return FieldKind.elementClass(written.type());
    }

    /** Returns the kind of a list's elements or a table's values. */
    public FieldKind elementKind() {
        return FieldKind.of(elementClass(), declaration());
    }

    /** Returns the record classes that the value, or an element of it, may have; empty if it is no record. */
    public List<Class<?>> recordClasses() {
        Class<?> type = kind == FieldKind.LIST || kind == FieldKind.TABLE ? elementClass() : valueClass();
        return RecordKind.classesOf(type);
    }

    /** Returns the name in words, without the unit: {@code radius} of {@code radiusMetres}. */
    public String title() {
        String bare = unit().isEmpty()
                ? name()
                : name().substring(0, name().length() - unitSuffix().length());
        StringBuilder words = new StringBuilder();
        for (char c : bare.toCharArray()) {
            words.append(Character.isUpperCase(c) ? " " + Character.toLowerCase(c) : String.valueOf(c));
        }
        return words.toString();
    }

    /** Returns the symbol of the unit, such as {@code m}; empty if there is none. */
    public String unit() {
        if (spatial() == Spatial.POINT || spatial() == Spatial.EXTENT || spatial() == Spatial.LENGTH) {
            return "m";
        }
        return UNITS.getOrDefault(unitSuffix(), "");
    }

    private String unitSuffix() {
        return UNITS.keySet().stream()
                .filter(name()::endsWith)
                .max(Comparator.comparingInt(String::length))
                .orElse("");
    }

    /** Returns the words of a choice, as files have them. */
    public List<Object> choices() {
        List<Object> all = new ArrayList<>();
        if (kind == FieldKind.CHOICE) {
            all.addAll(List.of(valueClass().getEnumConstants()));
        }
        return all;
    }
}
