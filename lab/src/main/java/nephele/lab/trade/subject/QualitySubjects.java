package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Sun;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** The presets of quality, the settings that change every pixel of a picture, and shadows. */
public final class QualitySubjects {
    private static final String SHADOW_FIELD = "shadowTexels";
    public static final Trade SHADOW = PictureSubjects.of(
            "shadow",
            PictureSubjects.text(SHADOW_FIELD, "the oracle: every shadow is a ray"),
            List.of(SHADOW_FIELD),
            PictureSubjects.usual(SHADOW_FIELD),
            Stream.concat(
                            Stream.of(new PictureSetting(
                                    new Setting("off", "no shadows at all"),
                                    shot -> shot.with(unshadowed(shot.level())))),
                            PictureSetting.all(SHADOW_FIELD, 256, 512, 1024, 2048, 4096, 8192).stream())
                    .toList());

    private static final String LIT_LEVEL = "levels/01-courtyard.json";
    private static final String REFERENCE = "the oracle: rays through the level, many a pixel";
    private static final String SEEN = "the oracle's picture as it is displayed";

    public static final Trade PRESETS = PictureSubjects.of(
            "quality",
            new Trade.Text(
                    "Presets of quality",
                    "Each preset is a point of the front that the other subjects measure: fewer pixels below,"
                            + " more samples above. Beside them, with the light of sun and lamps baked where the preset"
                            + " has it live, and the other way round.",
                    SEEN),
            List.of(),
            "high",
            Stream.concat(
                            Stream.of("low", "medium", "high", "ultra")
                                    .map(preset ->
                                            new PictureSetting(Setting.of(preset), shot -> shot.ofPreset(preset))),
                            Stream.of(
                                    otherLight("low", "live"),
                                    otherLight("medium", "baked"),
                                    otherLight("high", "baked")))
                    .toList(),
            ComparedValues.SEEN);

    public static final Trade RESOLUTION = PictureSubjects.setting(
            "pictureResolution",
            SEEN,
            PictureSetting.all("pictureResolution", "0.4", "0.5", "0.6", "0.75", "0.85", "1"),
            ComparedValues.SEEN);

    private static final List<PictureSetting> SIZES_AND_FILTERS = Stream.concat(
                    Stream.of("0.3", "0.4", "0.5", "0.67").flatMap(size -> Stream.of(
                                    "bilinear", "sharp_bilinear", "edge_adaptive")
                            .map(filter -> new PictureSetting(
                                    new Setting(filter + " " + size, filterNote(filter)),
                                    shot -> shot.set("pictureResolution", size).set("upscale", filter)))),
                    Stream.of(new PictureSetting(Setting.of("whole"), shot -> shot)))
            .toList();

    public static final Trade UPSCALE = new Trade(
            "upscale",
            PictureSubjects.text(
                    "upscale",
                    "the whole picture as displayed; shimmer against 16 samples a pixel. A halo is a flat colour that"
                            + " leaves the range of the drawn pixels around it, in codes of 8 bits"),
            List.of("upscale"),
            SIZES_AND_FILTERS.stream().map(PictureSetting::setting).toList(),
            SIZES_AND_FILTERS.size() - 1,
            ErrorMetric.DISPLAYED,
            UpscaleExperiment.FIGURES,
            UpscaleExperiment.COST,
            null,
            site -> new UpscaleExperiment(site, SIZES_AND_FILTERS));

    public static final Trade NORMAL_MAPS =
            PictureSubjects.setting("normalMaps", REFERENCE, PictureSetting.all("normalMaps", "off", "on"));

    public static final Trade BRDF =
            PictureSubjects.setting("brdf", REFERENCE, PictureSetting.all("brdf", "lambert", "ggx"));

    public static final Trade SHADOW_FILTER = PictureSubjects.setting(
            "shadowFilter", REFERENCE, PictureSetting.all("shadowFilter", "nearest", "bilinear"));

    public static final Trade LIGHT_PARTS = PictureSubjects.setting(
                    "lightParts", REFERENCE, PictureSetting.all("lightParts", "ambient", "diffuse", "specular", "all"))
            .in(LIT_LEVEL);

    public static final Trade LIGHT_SHADOWS = PictureSubjects.setting(
                    "lightShadows", REFERENCE, PictureSetting.all("lightShadows", 0, 1, 2, 4, 999))
            .in(LIT_LEVEL);

    public static final Trade CONTACT = PictureSubjects.setting(
                    "contact", REFERENCE, PictureSetting.all("contact", "off", "on"))
            .in("levels/04-cube.json");

    private QualitySubjects() {}

    private static PictureSetting otherLight(String preset, String light) {
        return new PictureSetting(Setting.of(preset + ", " + light + " light"), shot -> shot.ofPreset(preset)
                .set("directLight", light));
    }

    private static String filterNote(String filter) {
        return switch (filter) {
            case "sharp_bilinear" -> "software";
            case "edge_adaptive" -> "graphics cards";
            default -> "";
        };
    }

    /** Quality field {@code shadowTexels}, and shadows switched off. */
    private static Level unshadowed(Level level) {
        var light = level.environment();
        Sun sun = light.sun() == null
                ? null
                : new Sun(light.sun().directionTowardsSun(), light.sun().irradiance(), false);
        var environment = light.with(sun);
        return level.with(
                environment,
                level.lights().stream().map(QualitySubjects::unshadowed).toList());
    }

    private static Light unshadowed(Light light) {
        return light instanceof Light.Spot spot
                ? RecordCopy.with(spot, "castsShadow", false)
                : RecordCopy.with((Light.Point) light, "castsShadow", false);
    }
}
