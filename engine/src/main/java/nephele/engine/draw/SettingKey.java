package nephele.engine.draw;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Collectors;
import nephele.engine.render.RenderSettings;
import nephele.engine.terminal.CommandFailure;

/**
 * A setting that {@code --set} accepts.
 *
 * @param allowed description of the allowed values
 * @param change returns the change of the settings for a value, or {@code null} if the value is not allowed
 */
record SettingKey(String name, String allowed, Function<String, Function<RenderSettings, RenderSettings>> change) {
    static SettingKey whole(
            String name, int least, int most, BiFunction<RenderSettings, Integer, RenderSettings> change) {
        return new SettingKey(name, "a whole number from " + least + " to " + most, value -> {
            int number = value.matches("[0-9]{1,5}") ? Integer.parseInt(value) : -1;
            return number < least || number > most ? null : all -> change.apply(all, number);
        });
    }

    static SettingKey share(String name, double least, BiFunction<RenderSettings, Double, RenderSettings> change) {
        return new SettingKey(name, "a number from " + least + " to 1", value -> {
            double number = value.matches("[01](\\.[0-9]{1,9})?") ? Double.parseDouble(value) : -1;
            return number < least || number > 1 ? null : all -> change.apply(all, number);
        });
    }

    static SettingKey number(
            String name, double least, double most, BiFunction<RenderSettings, Double, RenderSettings> change) {
        return new SettingKey(name, "a number from " + least + " to " + most, value -> {
            double number = value.matches("[0-9]{1,3}(\\.[0-9]{1,9})?") ? Double.parseDouble(value) : Double.NaN;
            return number >= least && number <= most ? all -> change.apply(all, number) : null;
        });
    }

    static <E extends Enum<E>> SettingKey word(
            String name, Class<E> words, BiFunction<RenderSettings, E, RenderSettings> change) {
        var all = Arrays.stream(words.getEnumConstants())
                .collect(Collectors.toMap(word -> word.name().toLowerCase(Locale.ROOT), word -> word));
        var allowed = Arrays.stream(words.getEnumConstants())
                .map(word -> word.name().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(" or "));
        return new SettingKey(name, allowed, value -> {
            var word = all.get(value);
            return word == null ? null : settings -> change.apply(settings, word);
        });
    }

    RenderSettings applied(RenderSettings settings, String value) {
        var changed = change.apply(value);
        if (changed == null) {
            throw CommandFailure.usage("--set " + name + " is " + allowed + ", not `" + value + "`");
        }
        return changed.apply(settings);
    }
}
