package nephele.editor.session;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import nephele.engine.level.json.WordFormats;

/**
 * The values of a setting and their form in the file.
 *
 * @param expected the values in words, for messages
 * @param read returns the value of an entry; empty if it is none
 */
record EntryKind<T>(String expected, Function<JsonElement, Optional<T>> read, Function<T, JsonElement> write) {
    /** Bounds lists and maps, which a hostile or endless file could fill. */
    private static final int MOST_ENTRIES = 1_000;

    /** Returns one of an enum's constants, in the file with small letters and hyphens. */
    static <E extends Enum<E>> EntryKind<E> word(Class<E> type) {
        List<E> all = List.of(type.getEnumConstants());
        String words =
                String.join(", ", all.stream().map(WordFormats.Choice::word).toList());
        return new EntryKind<>(
                "one of " + words,
                json -> text(json).flatMap(text -> all.stream()
                        .filter(each -> WordFormats.Choice.word(each).equals(text))
                        .findFirst()),
                value -> new JsonPrimitive(WordFormats.Choice.word(value)));
    }

    /** Returns a whole number between bounds. */
    static EntryKind<Integer> whole(int least, int most) {
        return new EntryKind<>(
                "a whole number from " + least + " to " + most,
                json -> number(json)
                        .filter(number -> number >= least && number <= most && number == Math.rint(number))
                        .map(Double::intValue),
                JsonPrimitive::new);
    }

    /** Returns a number from 0 to 1. */
    static EntryKind<Double> fraction() {
        return new EntryKind<>(
                "a number from 0 to 1",
                json -> number(json).filter(number -> number >= 0 && number <= 1),
                JsonPrimitive::new);
    }

    /** Returns true or false. */
    static EntryKind<Boolean> flag() {
        return new EntryKind<>(
                "true or false",
                json -> json.isJsonPrimitive() && json.getAsJsonPrimitive().isBoolean()
                        ? Optional.of(json.getAsBoolean())
                        : Optional.empty(),
                JsonPrimitive::new);
    }

    /** Returns a text of at most 1000 characters. */
    static EntryKind<String> text() {
        return new EntryKind<>("a text", EntryKind::text, JsonPrimitive::new);
    }

    /** Returns a list of values; one bad element makes the whole list bad. */
    static <T> EntryKind<List<T>> list(EntryKind<T> element, int most) {
        return new EntryKind<>(
                "a list of at most " + most + ", each " + element.expected,
                json -> list(json, element, most),
                values -> {
                    JsonArray array = new JsonArray();
                    values.forEach(value -> array.add(element.write.apply(value)));
                    return array;
                });
    }

    private static <T> Optional<List<T>> list(JsonElement json, EntryKind<T> element, int most) {
        if (!json.isJsonArray() || json.getAsJsonArray().size() > most) {
            return Optional.empty();
        }
        List<T> values = new ArrayList<>();
        for (JsonElement each : json.getAsJsonArray()) {
            Optional<T> value = element.read.apply(each);
            if (value.isEmpty()) {
                return Optional.empty();
            }
            values.add(value.get());
        }
        return Optional.of(List.copyOf(values));
    }

    /** Returns values by their names; one bad value makes the whole map bad. */
    static <T> EntryKind<Map<String, T>> map(EntryKind<T> value) {
        return new EntryKind<>("names, each with " + value.expected, json -> map(json, value), values -> {
            JsonObject object = new JsonObject();
            values.forEach((name, each) -> object.add(name, value.write.apply(each)));
            return object;
        });
    }

    private static <T> Optional<Map<String, T>> map(JsonElement json, EntryKind<T> kind) {
        if (!json.isJsonObject() || json.getAsJsonObject().size() > MOST_ENTRIES) {
            return Optional.empty();
        }
        Map<String, T> values = new LinkedHashMap<>();
        for (Map.Entry<String, JsonElement> each : json.getAsJsonObject().entrySet()) {
            Optional<T> value = kind.read.apply(each.getValue());
            if (value.isEmpty()) {
                return Optional.empty();
            }
            values.put(each.getKey(), value.get());
        }
        return Optional.of(Collections.unmodifiableMap(values));
    }

    private static Optional<String> text(JsonElement json) {
        return json.isJsonPrimitive() && json.getAsJsonPrimitive().isString()
                ? Optional.of(json.getAsString()).filter(text -> text.length() <= 1_000)
                : Optional.empty();
    }

    private static Optional<Double> number(JsonElement json) {
        return json.isJsonPrimitive() && json.getAsJsonPrimitive().isNumber()
                ? Optional.of(json.getAsDouble())
                : Optional.empty();
    }
}
