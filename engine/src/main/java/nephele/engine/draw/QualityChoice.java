package nephele.engine.draw;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.named.AssetComplaint;
import nephele.engine.named.OpenedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Culling;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.RenderSettings.Narrowing;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.terminal.CommandFailure;

/**
 * A preset and what was changed in it by {@code --set}.
 *
 * @param preset low, medium, high, ultra or auto
 */
public record QualityChoice(String preset, Map<String, String> settings) {
    /** Every field of {@link Quality} and of {@link RenderSettings} that `--set` can change. */
    private static final List<SettingKey> KEYS = List.of(
            SettingKey.whole(
                    "anisotropy", 1, 16, (all, value) -> all.with(all.quality().withAnisotropy(value))),
            SettingKey.whole(
                    "shadowTexels",
                    64,
                    16384,
                    (all, value) -> all.with(all.quality().withShadowTexels(value))),
            SettingKey.whole(
                    "samples", 1, 8, (all, value) -> all.with(all.quality().withSamples(value))),
            SettingKey.word(
                    "portalTechnique",
                    PortalTechnique.class,
                    (all, value) -> all.with(all.quality().withPortalTechnique(value))),
            SettingKey.whole(
                    "viewBudget",
                    0,
                    9999,
                    (all, value) -> all.with(all.quality().withViewBudget(value))),
            SettingKey.share(
                    "portalResolution",
                    0.1,
                    (all, value) -> all.with(all.quality().withPortalResolution(value))),
            SettingKey.word("culling", Culling.class, RenderSettings::with),
            SettingKey.word("narrowing", Narrowing.class, RenderSettings::with),
            SettingKey.word("rims", Decoration.class, RenderSettings::with));

    private static final String DEBUG = "debug";

    /** Fails with wrong usage unless everything in here is known. */
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
                    case "auto" -> software ? Quality.LOW : Quality.ULTRA;
                    default ->
                        throw CommandFailure.usage(
                                "--quality is low, medium, high, ultra or auto, not `" + preset + "`");
                };
        return quality;
    }

    /** All that is drawn with. Ids are never blended, decorated or taken from another frame. */
    public RenderSettings settings(Output output, boolean software) {
        var all = RenderSettings.of(output, preset(software));
        for (var setting : settings.entrySet()) {
            if (!setting.getKey().equals(DEBUG)) {
                all = changed(all, setting.getKey(), setting.getValue());
            }
        }
        return showsIds()
                ? all.with(all.quality().withSamples(1)).with(Decoration.OFF).with(Deepest.MARK)
                : all;
    }

    /** The level that is drawn: the author's, or one that shows something else about it. */
    public Level shown(Level level) {
        return showsIds() ? IdLevel.of(level) : level;
    }

    /** The same with what follows from it. */
    public PlacedLevel shown(OpenedLevel opened) {
        return showsIds()
                ? AssetComplaint.named(opened, () -> opened.placed().edited(shown(opened.level())))
                : opened.placed();
    }

    /** What the level requires, unless values have to be drawn as they are. */
    public Output output(Level level) {
        return showsIds() ? Output.PLAIN : Outputs.requiredBy(level);
    }

    /** Every solid in a flat colour of its own. */
    public boolean showsIds() {
        return settings.containsKey(DEBUG);
    }

    private static RenderSettings changed(RenderSettings all, String name, String value) {
        var key = KEYS.stream().filter(known -> known.name().equals(name)).findFirst();
        if (key.isEmpty()) {
            var names = KEYS.stream().map(SettingKey::name).collect(Collectors.joining(", "));
            throw CommandFailure.usage("--set knows no `" + name + "`; it knows: " + names);
        }
        return key.get().applied(all, value);
    }
}
