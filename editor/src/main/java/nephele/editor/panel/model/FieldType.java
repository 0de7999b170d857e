package nephele.editor.panel.model;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import nephele.editor.added.AddedRecord;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.text.FieldWords;
import nephele.editor.text.Limits;
import nephele.editor.text.Words;
import nephele.engine.level.Exposure;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Spatial;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/**
 * The type of a value of a component, or of an entry of a list or table.
 *
 * @param field the component, also of an entry
 * @param kind of the value or entry
 * @param valueClass of the value or entry
 */
public record FieldType(RecordField field, FieldKind kind, Class<?> valueClass) {
    /** The id of a new record, and a reference to a record that is still to be found. */
    static final String NEW = "new";

    /** Files that come with the game, by the components that may be without one. */
    private static final Map<String, String> STANDARD_FILES = Map.of(
            "texture", "textures/plaster.png",
            "normalTexture", "textures/plaster-normal.png",
            "coverageMap", "textures/clouds/painted.png",
            "densityMap", "terrain/hills.png");

    private static final Pattern COLOUR =
            Pattern.compile(".*(colour|emission|radiance|intensity|ambient|albedo|zenith|horizon|ground)");

    /** Returns the type of a component's value. */
    public static FieldType of(RecordField field) {
        return new FieldType(field, field.kind(), field.valueClass());
    }

    /** Returns the type of an entry of a list or table. */
    public static FieldType ofEntry(RecordField field) {
        return new FieldType(field, field.elementKind(), field.elementClass());
    }

    private Written declaration() {
        return field.declaration();
    }

    private boolean isEntry() {
        return kind != field.kind();
    }

    /** Returns true if the value may be absent. */
    public boolean isNullable() {
        return !isEntry() && field.isNullable();
    }

    /** Returns true for a vector that is a linear RGB colour. */
    public boolean isColour() {
        return kind == FieldKind.VECTOR
                && field.spatial() == Spatial.NONE
                && COLOUR.matcher(field.name().toLowerCase(Locale.ROOT)).matches();
    }

    /** Returns the section whose ids the value is one of; empty for none. */
    public String refersTo() {
        return declaration().refersTo();
    }

    /** Returns the classes that a record may have. */
    public List<RecordKind> kinds() {
        return field.recordClasses().stream().map(RecordKind::of).toList();
    }

    /** Returns the constants of a choice. */
    public List<Object> choices() {
        return kind == FieldKind.CHOICE ? List.of((Object[]) valueClass.getEnumConstants()) : List.of();
    }

    /** Returns true if {@link #defaultValue} is one; a place or an id has none. */
    public boolean hasDefault() {
        return !isEntry() && (!field.isRequired() || field.written().prototype() != null);
    }

    /** Returns the value of an absent key, or of a new entity if the key is required; may be {@code null}. */
    public Object defaultValue() {
        return field.isRequired()
                ? field.written().prototype()
                : field.written().absent();
    }

    /** Returns a value for a place that had none; a reference names what {@link AddedRecord} makes of it. */
    public Object freshValue() {
        if (!isEntry() && field.written().prototype() != null) {
            return field.written().prototype();
        } else if (!isEntry() && field.written().absent() != null) {
            return field.written().absent();
        }
        double number = field.range() == null ? 1 : field.range().nearest(1);
        return switch (kind) {
            case NUMBER -> number;
            case WHOLE -> whole(number);
            case TRUTH -> true;
            case TEXT, REFERENCE -> NEW;
            case ASSET -> STANDARD_FILES.getOrDefault(field.name(), "");
            case CHOICE -> choices().get(0);
            case VECTOR -> new Vec3(number, number, number);
            case EXPOSURE -> Exposure.NEUTRAL;
            case RECORD, VARIANT -> AddedRecord.at(kinds().get(0), NEW, Vec3.ZERO);
            case LIST -> List.of();
            case TABLE -> Map.of();
        };
    }

    /** Returns a number as the value's class has it. */
    public Object number(double value) {
        return switch (kind) {
            case WHOLE -> whole(value);
            case EXPOSURE -> Exposure.ofStops(value);
            default -> value;
        };
    }

    /** Returns true if {@link #shifted} changes values. */
    public boolean isShifted() {
        return kind == FieldKind.NUMBER || kind == FieldKind.WHOLE || kind == FieldKind.EXPOSURE;
    }

    /** Returns a number with another one added; any other value as it is. */
    public Object shifted(Object value, double change) {
        if (value instanceof Exposure exposure && !exposure.isAuto()) {
            return number(exposure.fixedStops() + change);
        }
        return value instanceof Number number ? number(number.doubleValue() + change) : value;
    }

    private Object whole(double value) {
        return valueClass == int.class || valueClass == Integer.class
                ? (Object) (int) Math.floor(value + 0.5)
                : (Object) Math.round(value);
    }

    /** Returns the value that a text names; empty if it is none that is permitted, or the type has no short text. */
    public Optional<Object> read(String text) {
        Optional<Object> value =
                switch (kind) {
                    case NUMBER, WHOLE -> number(text).map(this::number);
                    case TRUTH ->
                        text.equals("true") || text.equals("false")
                                ? Optional.of(Boolean.valueOf(text))
                                : Optional.empty();
                    case TEXT, REFERENCE, ASSET -> Optional.of(text);
                    case CHOICE ->
                        choices().stream()
                                .filter(choice ->
                                        FieldWords.choiceInFiles(choice).equals(text.toLowerCase(Locale.ROOT)))
                                .findFirst();
                    case VECTOR -> vector(text);
                    case EXPOSURE ->
                        text.equals(Exposure.AUTO_WORD)
                                ? Optional.of(Exposure.AUTO)
                                : number(text).map(this::number);
                    case RECORD, VARIANT, LIST, TABLE -> Optional.empty();
                };
        return value.filter(each -> problem(each).isEmpty());
    }

    /** Returns a number that the kind may be. */
    private Optional<Double> number(String text) {
        OptionalDouble value = NumberExpression.evaluate(text);
        boolean isFine =
                value.isPresent() && (kind != FieldKind.WHOLE || value.getAsDouble() == Math.rint(value.getAsDouble()));
        return isFine ? Optional.of(value.getAsDouble()) : Optional.empty();
    }

    private Optional<Object> vector(String text) {
        double[] parts = Arrays.stream(text.split(",", -1))
                .mapToDouble(part -> number(part).orElse(Double.NaN))
                .toArray();
        boolean isFine = parts.length == 3 && Arrays.stream(parts).noneMatch(Double::isNaN);
        return isFine ? Optional.of(new Vec3(parts[0], parts[1], parts[2])) : Optional.empty();
    }

    /** Returns what is wrong with a value, and what would be right. */
    public Optional<Words> problem(Object value) {
        return Limits.problem(field, value);
    }

    /** Returns the range in words, such as {@code 0 … 1}; empty if it is only the size of the world. */
    public String range() {
        NumberRange range = field.range();
        return range == null || range.stretches().equals(NumberRange.WORLD.stretches())
                ? ""
                : range.text("%s … %s", ", ", NumberExpression::text);
    }
}
