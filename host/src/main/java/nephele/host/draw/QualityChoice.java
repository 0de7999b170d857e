package nephele.host.draw;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.LinearLight;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.Antialiasing;
import nephele.engine.render.frame.QualityField;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.CommandFailure;

/**
 * A quality preset with the changes made by {@code --set}.
 *
 * @param preset low, medium, high, ultra or auto
 * @param settings values by name, not checked yet
 */
public record QualityChoice(String preset, Map<String, String> settings) {
    /** Every setting that {@code --set} can change. */
    public static final List<QualityField> FIELDS = Stream.concat(
                    Quality.FIELDS.stream(), RenderSettings.FIELDS.stream())
            .toList();

    private static final String DEBUG = "debug";

    /** Throws a usage {@link CommandFailure} unless the preset and all settings are known and in range. */
    public void check() {
        if (showsIds() && !settings.get(DEBUG).equals("ids")) {
            throw CommandFailure.usage("--set debug is ids, not `" + settings.get(DEBUG) + "`");
        }
        settings(Output.DIRECT, true);
    }

    private Quality preset(boolean software) {
        var quality =
                switch (preset.toLowerCase(Locale.ROOT)) {
                    case "low" -> Quality.LOW;
                    case "medium" -> Quality.MEDIUM;
                    case "high" -> Quality.HIGH;
                    case "ultra" -> Quality.ULTRA;
                    case "auto" -> QualityFront.of(software).first().quality();
                    default ->
                        throw CommandFailure.usage(
                                "--quality is low, medium, high, ultra or auto, not `" + preset + "`");
                };
        return software ? quality : quality.onHardware();
    }

    /** Returns true if the quality follows the frame rate. */
    public boolean isAuto() {
        return preset.equalsIgnoreCase("auto");
    }

    /**
     * Returns all render settings. Ids are drawn without multisampling, decoration or reuse of other frames.
     *
     * @param software true for a software renderer: auto begins with low instead of ultra, and presets have fewer samples
     * @throws CommandFailure for an unknown preset or setting
     */
    public RenderSettings settings(Output output, boolean software) {
        return settings(output, preset(software));
    }

    /** Returns all render settings, from a quality in place of the preset. */
    public RenderSettings settings(Output output, Quality quality) {
        var all = RenderSettings.of(output, quality).with(quality);
        for (var setting : settings.entrySet()) {
            if (!setting.getKey().equals(DEBUG)) {
                all = changed(all, setting.getKey(), setting.getValue());
            }
        }
        return showsIds()
                ? all.with(all.quality()
                                .with("samples", 1)
                                .with("antialiasing", Antialiasing.NONE)
                                .with("pictureResolution", 1))
                        .with(Decoration.OFF)
                        .with(Deepest.MARK)
                : all;
    }

    /** Returns the level to draw: the author's, or its variant for debugging. */
    public Level drawn(Level level) {
        return showsIds() ? IdLevel.of(level) : level;
    }

    /** Returns the level to draw with its derived data. */
    public PlacedLevel drawn(OpenedLevel opened) {
        return showsIds() ? opened.reporting(() -> opened.placed().edited(drawn(opened.level()))) : opened.placed();
    }

    /**
     * Returns the light of a level to draw.
     *
     * @param name of the level in messages
     * @param progress of a bake, 0–1
     * @param warnings receives a line if baked light is there and ignored; not for ids, which show none
     */
    public BakedLight light(PlacedLevel drawn, String name, DoubleConsumer progress, Consumer<String> warnings) {
        return LevelLight.of(drawn, progress, stored -> {
            if (!showsIds()) {
                stored.warning(name).ifPresent(warnings);
            }
        });
    }

    /** Returns the output that the level requires; PLAIN for ids, so that colours are drawn unchanged. */
    public Output output(Level level) {
        return showsIds() ? Output.PLAIN : defaultOutput(level);
    }

    /** Returns HDR if something in the level adds light to the image, otherwise DIRECT. */
    public static Output defaultOutput(Level level) {
        return LinearLight.because(level).isPresent() ? Output.HDR : Output.DIRECT;
    }

    /** Returns true if each surface is drawn in a unique flat colour. */
    public boolean showsIds() {
        return settings.containsKey(DEBUG);
    }

    private static RenderSettings changed(RenderSettings all, String name, String value) {
        var field = FIELDS.stream().filter(known -> known.name().equals(name)).findFirst();
        if (field.isEmpty()) {
            throw CommandFailure.usage("--set knows no `" + name + "`; it knows: " + QualityField.names(FIELDS));
        }
        var parsed = field.get().parsed(value);
        if (parsed.isEmpty()) {
            throw CommandFailure.usage("--set " + name + " is " + field.get().allowed() + ", not `" + value + "`");
        }
        return all.with(field.get(), parsed.get());
    }
}
