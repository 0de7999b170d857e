package nephele.engine.render.frame;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.engine.level.RecordCopy;
import nephele.engine.render.frame.Quality.Preset;

/**
 * A setting as it was declared on its component.
 *
 * @param name in {@code --set}
 * @param component its name in Java
 * @param type int, double or an enum
 */
public record QualityField(String name, String component, Class<?> type, QualitySetting declared) {
    /** Returns the declared settings of a record, in the order of its components. */
    public static List<QualityField> of(Class<? extends Record> settings) {
        return Arrays.stream(settings.getRecordComponents())
                .filter(component -> component.isAnnotationPresent(QualitySetting.class))
                .map(QualityField::of)
                .toList();
    }

    private static QualityField of(RecordComponent component) {
        var declared = component.getAnnotation(QualitySetting.class);
        String name = declared.name().isEmpty() ? component.getName() : declared.name();
        return new QualityField(name, component.getName(), component.getType(), declared);
    }

    /** Returns a record whose components are these settings, with the values of a preset. */
    static <R extends Record> R record(Class<R> settings, List<QualityField> fields, Preset preset) {
        return RecordCopy.of(
                settings,
                fields.stream()
                        .map(field -> field.parsed(field.in(preset)).orElseThrow())
                        .toArray());
    }

    /** Returns the value in a preset, as {@code --set} writes it. */
    public String in(Preset preset) {
        String value =
                switch (preset) {
                    case LOW -> declared.low();
                    case MEDIUM -> declared.medium();
                    case HIGH -> declared.high();
                    case ULTRA -> declared.ultra();
                };
        return value.isEmpty() ? declared.high() : value;
    }

    /** Returns true if all presets have the same value: the others are alternatives for measuring. */
    public boolean isAlternative() {
        return Stream.of(Preset.values()).map(this::in).distinct().count() == 1;
    }

    /** Returns the presets that have a value, for a reader: {@code all presets}, {@code low and high}; empty for none. */
    public String presetsWith(String value) {
        List<String> presets = Stream.of(Preset.values())
                .filter(preset -> in(preset).equals(value))
                .map(preset -> preset.name().toLowerCase(Locale.ROOT))
                .toList();
        int last = presets.size() - 1;
        if (last < 1) {
            return String.join("", presets);
        }
        return last == Preset.values().length - 1
                ? "all presets"
                : String.join(", ", presets.subList(0, last)) + " and " + presets.get(last);
    }

    /** Returns the words that it accepts; empty for a number. */
    public List<String> words() {
        return type.isEnum()
                ? Stream.of(type.getEnumConstants()).map(QualityField::word).toList()
                : List.of();
    }

    /** Returns a description of the values that it accepts. */
    public String allowed() {
        if (type.isEnum()) {
            return String.join(" or ", words());
        } else if (type == int.class) {
            return "a whole number from " + (int) declared.least() + " to " + (int) declared.most();
        }
        return "a number from " + declared.least() + " to " + (isFraction() ? "1" : declared.most());
    }

    private boolean isFraction() {
        return declared.most() == 1;
    }

    /** Returns the value that a text states, of {@link #type}; empty if it accepts no such text. */
    public Optional<Object> parsed(String text) {
        if (type.isEnum()) {
            return Stream.of(type.getEnumConstants())
                    .filter(value -> word(value).equals(text))
                    .map(Object.class::cast)
                    .findFirst();
        } else if (type == int.class) {
            return text.matches("[0-9]{1,5}") && isInRange(Integer.parseInt(text))
                    ? Optional.of(Integer.valueOf(text))
                    : Optional.empty();
        }
        return text.matches(isFraction() ? "[01](\\.[0-9]{1,9})?" : "[0-9]{1,3}(\\.[0-9]{1,9})?")
                        && isInRange(Double.parseDouble(text))
                ? Optional.of(Double.valueOf(text))
                : Optional.empty();
    }

    private boolean isInRange(double number) {
        return number >= declared.least() && number <= declared.most();
    }

    private static String word(Object value) {
        return ((Enum<?>) value).name().toLowerCase(Locale.ROOT);
    }

    /** Returns the names of settings, with commas. */
    public static String names(List<QualityField> fields) {
        return fields.stream().map(QualityField::name).collect(Collectors.joining(", "));
    }
}
