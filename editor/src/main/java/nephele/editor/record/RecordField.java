package nephele.editor.record;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Spatial;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.WrittenField;

/** A component of a record: its name, kind, limits and defaults. */
public record RecordField(int index, WrittenField written, FieldKind kind) {
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

    private String unitSuffix() {
        return Unit.of(name()).map(Unit::suffix).orElse("");
    }

    /** Returns the symbol of the unit, such as {@code m}; empty if there is none. */
    public String unit() {
        if (spatial() == Spatial.POINT || spatial() == Spatial.EXTENT || spatial() == Spatial.LENGTH) {
            return "m";
        }
        return Unit.of(name()).map(Unit::symbol).orElse("");
    }

    /** Units that names of components end with. */
    private enum Unit {
        METRES_PER_SECOND("MetresPerSecond", "m/s"),
        PER_METRE("PerMetre", "1/m"),
        METRES("Metres", "m"),
        DEGREES("Degrees", "°"),
        KILOGRAMS("Kilograms", "kg"),
        HOURS("Hours", "h"),
        SECONDS("Seconds", "s"),
        STOPS("Stops", "EV");

        private final String suffix;
        private final String symbol;

        Unit(String suffix, String symbol) {
            this.suffix = suffix;
            this.symbol = symbol;
        }

        String suffix() {
            return suffix;
        }

        String symbol() {
            return symbol;
        }

        static java.util.Optional<Unit> of(String name) {
            return java.util.Arrays.stream(values())
                    .filter(unit -> name.endsWith(unit.suffix))
                    .findFirst();
        }
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
