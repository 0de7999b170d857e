package nephele.app.settings;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonPrimitive;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import nephele.app.window.KeyBindings;
import nephele.app.window.KeyNames;

/**
 * A setting of the game: its key in the file, its values, its default and its place in the menu. Its name and its line
 * of help are the phrases {@code SETTING_…} and {@code HELP_…} of its key.
 *
 * @param absent the value of a missing or broken entry
 * @param group {@code null} for one that no group of the menu has
 */
public record GameSetting<T>(String key, Values<T> values, T absent, Group group) {
    /** The groups of the menu, in its order. */
    public enum Group {
        PICTURE,
        WINDOW,
        VIEW,
        COMFORT,
        AIDS
    }

    private GameSetting(String key, Values<T> values, T absent) {
        this(key, values, absent, null);
    }

    /** Returns this setting in a group of the menu. */
    GameSetting<T> in(Group chosen) {
        return new GameSetting<>(key, values, absent, chosen);
    }

    /** The values of a setting. */
    public interface Values<T> {
        /** Returns the value of an entry; empty if it is none of the values. */
        Optional<T> read(JsonElement json);

        /** Returns the entry of a value. */
        JsonElement write(T value);

        /**
         * Returns the value that a player gets by a step in the menu, around both ends for words.
         *
         * @param step +1 or −1
         */
        T stepped(T value, int step);

        /** Returns the values in words, for messages. */
        String expected();
    }

    /** One of a few words: the lower-case names of an enum's constants, with hyphens. */
    public static <E extends Enum<E>> GameSetting<E> word(String key, E absent) {
        return new GameSetting<>(
                key, new Words<>(List.of(absent.getDeclaringClass().getEnumConstants()), GameSetting::word), absent);
    }

    /** A setting with a few texts as values; the first one is the default. */
    public static GameSetting<String> choice(String key, List<String> all) {
        return new GameSetting<>(key, new Words<>(all, text -> text), all.get(0));
    }

    /** A number between bounds; a step of the menu adds or subtracts {@code step}. */
    public static GameSetting<Double> number(String key, double least, double most, double step, double absent) {
        return new GameSetting<>(key, new Numbers(least, most, step, false), absent);
    }

    /** A rate a second between bounds, or 0 for none; a rate close to 0 would stop what waits for it. */
    static GameSetting<Double> rate(String key, double least, double most, double step) {
        return new GameSetting<>(key, new Numbers(least, most, step, true), 0.0);
    }

    /** Names of keys; steps of the menu do not change them. */
    static GameSetting<List<String>> keys(String key, List<String> absent) {
        return new GameSetting<>(key, new Keys(), absent);
    }

    /** Returns the word of an enum's constant. */
    public static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** @param word gives the text of a value */
    private record Words<T>(List<T> all, Function<T, String> word) implements Values<T> {
        @Override
        public Optional<T> read(JsonElement json) {
            return json.isJsonPrimitive() && json.getAsJsonPrimitive().isString()
                    ? all.stream()
                            .filter(each -> word.apply(each).equals(json.getAsString()))
                            .findFirst()
                    : Optional.empty();
        }

        @Override
        public JsonElement write(T value) {
            return new JsonPrimitive(word.apply(value));
        }

        @Override
        public T stepped(T value, int step) {
            return all.get(Math.floorMod(all.indexOf(value) + step, all.size()));
        }

        @Override
        public String expected() {
            return "one of " + String.join(", ", all.stream().map(word).toList());
        }
    }

    private record Keys() implements Values<List<String>> {
        @Override
        public Optional<List<String>> read(JsonElement json) {
            if (!json.isJsonArray() || json.getAsJsonArray().size() > KeyBindings.MOST_KEYS) {
                return Optional.empty();
            }
            List<String> names = new ArrayList<>();
            for (JsonElement name : json.getAsJsonArray()) {
                if (!name.isJsonPrimitive() || KeyNames.code(name.getAsString()) == null) {
                    return Optional.empty();
                }
                names.add(name.getAsString());
            }
            return Optional.of(List.copyOf(names));
        }

        @Override
        public JsonElement write(List<String> value) {
            JsonArray names = new JsonArray();
            value.forEach(names::add);
            return names;
        }

        @Override
        public List<String> stepped(List<String> value, int step) {
            return value;
        }

        @Override
        public String expected() {
            return "a list of at most " + KeyBindings.MOST_KEYS + " names of keys, such as \"W\" or \"Mouse 1\"";
        }
    }

    /** @param orZero whether 0 is a value too, though it is less than the least */
    private record Numbers(double least, double most, double step, boolean orZero) implements Values<Double> {
        @Override
        public Optional<Double> read(JsonElement json) {
            if (!json.isJsonPrimitive() || !json.getAsJsonPrimitive().isNumber()) {
                return Optional.empty();
            }
            double value = json.getAsDouble();
            return value >= least && value <= most || orZero && value == 0 ? Optional.of(value) : Optional.empty();
        }

        @Override
        public JsonElement write(Double value) {
            return value == Math.rint(value) ? new JsonPrimitive(value.longValue()) : new JsonPrimitive(value);
        }

        @Override
        public Double stepped(Double value, int direction) {
            if (orZero && value + direction * step < least) {
                return 0.0;
            }
            double next = step * Math.rint((value + direction * step) / step);
            return Math.max(least, Math.min(most, next));
        }

        @Override
        public String expected() {
            return (orZero ? "0 or " : "") + "a number from " + text(least) + " to " + text(most);
        }

        private static String text(double number) {
            return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
        }
    }
}
