package nephele.engine.draw;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import nephele.engine.cloud.drawn.SkyplaneShape;
import nephele.engine.cloud.light.BallLight;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.named.AssetProblems;
import nephele.engine.named.OpenedLevel;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.RenderSettings.Culling;
import nephele.engine.render.RenderSettings.Decoration;
import nephele.engine.render.RenderSettings.Deepest;
import nephele.engine.render.RenderSettings.Narrowing;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.PortalTechnique;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.BillboardFacing;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.frame.Quality.EdgeFilter;
import nephele.engine.render.frame.Quality.ImpostorChoice;
import nephele.engine.render.frame.Quality.LayerMixing;
import nephele.engine.render.frame.Quality.LightParts;
import nephele.engine.render.frame.Quality.NormalMaps;
import nephele.engine.render.frame.Quality.ReflectionModel;
import nephele.engine.render.frame.Quality.ShadowSampling;
import nephele.engine.render.frame.Quality.SpriteCoverage;
import nephele.engine.render.frame.Quality.TerrainDetail;
import nephele.engine.render.frame.Quality.Upscale;
import nephele.engine.terminal.CommandFailure;

/**
 * A quality preset with the changes made by {@code --set}.
 *
 * @param preset low, medium, high, ultra or auto
 * @param settings values by name, not checked yet
 */
public record QualityChoice(String preset, Map<String, String> settings) {
    /** Every field of {@link Quality} and of {@link RenderSettings} that {@code --set} can change. */
    private static final List<SettingKey> KEYS = List.of(
            SettingKey.share(
                    "pictureResolution",
                    0.25,
                    (all, value) -> all.with(all.quality().withPictureResolution(value))),
            SettingKey.word(
                    "upscale",
                    Upscale.class,
                    (all, value) -> all.with(all.quality().withUpscale(value))),
            SettingKey.whole(
                    "anisotropy", 1, 16, (all, value) -> all.with(all.quality().withAnisotropy(value))),
            SettingKey.word(
                    "normalMaps",
                    NormalMaps.class,
                    (all, value) -> all.with(all.quality().withNormalMaps(value))),
            SettingKey.word(
                    "brdf",
                    ReflectionModel.class,
                    (all, value) -> all.with(all.quality().withBrdf(value))),
            SettingKey.whole(
                    "shadowTexels",
                    64,
                    16384,
                    (all, value) -> all.with(all.quality().withShadowTexels(value))),
            SettingKey.word(
                    "shadowFilter",
                    ShadowSampling.class,
                    (all, value) -> all.with(all.quality().withShadowFilter(value))),
            SettingKey.whole(
                    "lightShadows",
                    0,
                    Quality.ALL_LIGHTS,
                    (all, value) -> all.with(all.quality().withLightShadows(value))),
            SettingKey.whole(
                    "samples", 1, 8, (all, value) -> all.with(all.quality().withSamples(value))),
            SettingKey.word(
                    "edgeFilter",
                    EdgeFilter.class,
                    (all, value) -> all.with(all.quality().withEdgeFilter(value))),
            SettingKey.share(
                    "cloudResolution",
                    0.125,
                    (all, value) -> all.with(all.quality().withCloudResolution(value))),
            SettingKey.word(
                    "cloudHistory",
                    CloudHistory.class,
                    (all, value) -> all.with(all.quality().withCloudHistory(value))),
            SettingKey.number(
                    "cloudStep",
                    0.25,
                    16,
                    (all, value) -> all.with(all.quality().withCloudStep(value))),
            SettingKey.whole(
                    "cloudLightCell",
                    1,
                    8,
                    (all, value) -> all.with(all.quality().withCloudLightCell(value))),
            SettingKey.word(
                    "cloudScattering",
                    CloudScattering.class,
                    (all, value) -> all.with(all.quality().withCloudScattering(value))),
            SettingKey.word(
                    "billboardFacing",
                    BillboardFacing.class,
                    (all, value) -> all.with(all.quality().withBillboardFacing(value))),
            SettingKey.word(
                    "particleLight",
                    BallLight.class,
                    (all, value) -> all.with(all.quality().withParticleLight(value))),
            SettingKey.word(
                    "impostors",
                    ImpostorChoice.class,
                    (all, value) -> all.with(all.quality().withImpostors(value))),
            SettingKey.number(
                    "impostorErrorPixels",
                    0.1,
                    16,
                    (all, value) -> all.with(all.quality().withImpostorErrorPixels(value))),
            SettingKey.word(
                    "skyplaneShape",
                    SkyplaneShape.class,
                    (all, value) -> all.with(all.quality().withSkyplaneShape(value))),
            SettingKey.word(
                    "proceduralNoise",
                    ProceduralNoise.class,
                    (all, value) -> all.with(all.quality().withProceduralNoise(value))),
            SettingKey.whole(
                    "cloudSkyboxTexels",
                    16,
                    4096,
                    (all, value) -> all.with(all.quality().withCloudSkyboxTexels(value))),
            SettingKey.word(
                    "terrainDetail",
                    TerrainDetail.class,
                    (all, value) -> all.with(all.quality().withTerrainDetail(value))),
            SettingKey.number(
                    "terrainErrorPixels",
                    0.1,
                    64,
                    (all, value) -> all.with(all.quality().withTerrainErrorPixels(value))),
            SettingKey.number(
                    "impostorPixels",
                    0,
                    256,
                    (all, value) -> all.with(all.quality().withImpostorPixels(value))),
            SettingKey.word(
                    "terrainLayers",
                    LayerMixing.class,
                    (all, value) -> all.with(all.quality().withTerrainLayers(value))),
            SettingKey.word(
                    "spriteCoverage",
                    SpriteCoverage.class,
                    (all, value) -> all.with(all.quality().withSpriteCoverage(value))),
            SettingKey.word(
                    "lightParts",
                    LightParts.class,
                    (all, value) -> all.with(all.quality().withLightParts(value))),
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

    /** Returns the names of the settings that {@code --set} can change. */
    public static List<String> keys() {
        return KEYS.stream().map(SettingKey::name).toList();
    }

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
        var all = RenderSettings.of(output, quality);
        for (var setting : settings.entrySet()) {
            if (!setting.getKey().equals(DEBUG)) {
                all = changed(all, setting.getKey(), setting.getValue());
            }
        }
        return showsIds()
                ? all.with(all.quality()
                                .withSamples(1)
                                .withEdgeFilter(EdgeFilter.NONE)
                                .withPictureResolution(1))
                        .with(Decoration.OFF)
                        .with(Deepest.MARK)
                : all;
    }

    /** Returns the level to draw: the author's, or its variant for debugging. */
    public Level shown(Level level) {
        return showsIds() ? IdLevel.of(level) : level;
    }

    /** Returns the level to draw with its derived data. */
    public PlacedLevel shown(OpenedLevel opened) {
        return showsIds()
                ? AssetProblems.named(opened, () -> opened.placed().edited(shown(opened.level())))
                : opened.placed();
    }

    /** Returns the output that the level requires; PLAIN for ids, so that colours are drawn unchanged. */
    public Output output(Level level) {
        return showsIds() ? Output.PLAIN : Outputs.defaultFor(level);
    }

    /** Returns true if each surface is drawn in a unique flat colour. */
    public boolean showsIds() {
        return settings.containsKey(DEBUG);
    }

    private static RenderSettings changed(RenderSettings all, String name, String value) {
        var key = KEYS.stream().filter(known -> known.name().equals(name)).findFirst();
        if (key.isEmpty()) {
            throw CommandFailure.usage("--set knows no `" + name + "`; it knows: " + String.join(", ", keys()));
        }
        return key.get().applied(all, value);
    }
}
