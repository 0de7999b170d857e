package nephele.app.draw;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import nephele.app.terminal.CommandFailure;
import nephele.engine.level.Level;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;

/**
 * A preset and what was changed in it by {@code --set}.
 *
 * @param preset low, medium, high, ultra or auto
 */
public record QualityChoice(String preset, Map<String, String> settings) {
    /** Every field of {@link Quality} that `--set` can change. */
    private static final List<Field> FIELDS = List.of(
            new Field(
                    "anisotropy",
                    1,
                    16,
                    (quality, value) -> new Quality(value, quality.shadowTexels(), quality.samples())),
            new Field(
                    "shadowTexels",
                    64,
                    16384,
                    (quality, value) -> new Quality(quality.anisotropy(), value, quality.samples())),
            new Field("samples", 1, 8, (quality, value) -> quality.withSamples(value)));

    private static final String DEBUG = "debug";

    private record Field(String key, int least, int most, BiFunction<Quality, Integer, Quality> change) {
        boolean takes(String value) {
            return value.matches("[0-9]{1,5}") && Integer.parseInt(value) >= least && Integer.parseInt(value) <= most;
        }
    }

    /** Fails with wrong usage unless everything in here is known. */
    public void check() {
        if (showsIds() && !settings.get(DEBUG).equals("ids")) {
            throw CommandFailure.usage("--set debug is ids, not `" + settings.get(DEBUG) + "`");
        }
        on(true);
    }

    /** The quality for a machine: auto is low where OpenGL runs in software, else ultra. Ids are never blended. */
    public Quality on(boolean software) {
        var quality =
                switch (preset.toLowerCase(Locale.ROOT)) {
                    case "low" -> Quality.LOW;
                    case "medium" -> Quality.MEDIUM;
                    case "high" -> Quality.HIGH;
                    case "ultra" -> Quality.ULTRA;
                    case "auto" -> software ? Quality.LOW : Quality.ULTRA;
                    default ->
                        throw CommandFailure.usage(
                                "--quality is low, medium, high, ultra or auto, not `" + preset + "`");
                };
        for (var setting : settings.entrySet()) {
            if (!setting.getKey().equals(DEBUG)) {
                quality = changed(quality, setting.getKey(), setting.getValue());
            }
        }
        return showsIds() ? quality.withSamples(1) : quality;
    }

    /** The level that is drawn: the author's, or one that shows something else about it. */
    public Level shown(Level level) {
        return showsIds() ? IdLevel.of(level) : level;
    }

    /** What the level requires, unless values have to be drawn as they are. */
    public Output output(Level level) {
        return showsIds() ? Output.PLAIN : Outputs.requiredBy(level);
    }

    /** Every solid in a flat colour of its own. */
    public boolean showsIds() {
        return settings.containsKey(DEBUG);
    }

    private static Quality changed(Quality quality, String key, String value) {
        var known = FIELDS.stream().filter(field -> field.key.equals(key)).findFirst();
        if (known.isEmpty()) {
            var keys = FIELDS.stream().map(Field::key).collect(Collectors.joining(", "));
            throw CommandFailure.usage("--set knows no `" + key + "`; it knows: " + keys);
        }
        var field = known.get();
        if (!field.takes(value)) {
            throw CommandFailure.usage("--set " + key + " is a whole number from " + field.least + " to " + field.most
                    + ", not `" + value + "`");
        }
        return field.change.apply(quality, Integer.parseInt(value));
    }
}
