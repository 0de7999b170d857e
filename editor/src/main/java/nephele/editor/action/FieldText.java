package nephele.editor.action;

import java.util.Locale;
import java.util.Optional;
import nephele.editor.record.RecordField;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/** Reads the text of a component's value in a script. */
final class FieldText {
    private FieldText() {}

    /** Returns the value; empty if the text is none that the component permits. */
    static Optional<Object> read(RecordField field, String text) {
        return switch (field.kind()) {
            case NUMBER -> number(field, text).map(value -> value);
            case WHOLE ->
                number(field, text)
                        .filter(value -> value == Math.rint(value))
                        .map(value -> field.valueClass() == int.class ? (Object) value.intValue() : value.longValue());
            case TRUTH ->
                text.equals("true") || text.equals("false") ? Optional.of(Boolean.valueOf(text)) : Optional.empty();
            case TEXT, REFERENCE, ASSET -> {
                int length = text.length();
                var kind = field.declaration().text();
                yield length < kind.shortest() || length > kind.longest() ? Optional.empty() : Optional.of(text);
            }
            case CHOICE ->
                field.choices().stream()
                        .filter(choice -> word(choice).equals(text.toLowerCase(Locale.ROOT)))
                        .findFirst();
            case VECTOR -> vector(field, text);
            case RECORD, VARIANT, LIST, TABLE -> Optional.empty();
        };
    }

    /** A side of a box is written by its normal, every other choice by its name. */
    private static String word(Object choice) {
        if (choice instanceof nephele.engine.level.BoxFace face) {
            return face.text();
        }
        return ((Enum<?>) choice).name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static Optional<Double> number(RecordField field, String text) {
        try {
            double value = Double.parseDouble(text.trim());
            Written limits = field.declaration();
            return value >= limits.min() && value <= limits.max() ? Optional.of(value) : Optional.empty();
        } catch (NumberFormatException noNumber) {
            return Optional.empty();
        }
    }

    private static Optional<Object> vector(RecordField field, String text) {
        String[] parts = text.split(",", -1);
        double[] values = new double[3];
        if (parts.length != values.length) {
            return Optional.empty();
        }
        for (int i = 0; i < values.length; i++) {
            Optional<Double> value = number(field, parts[i]);
            if (value.isEmpty()) {
                return Optional.empty();
            }
            values[i] = value.get();
        }
        return Optional.of(new Vec3(values[0], values[1], values[2]));
    }
}
