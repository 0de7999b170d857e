package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** The presets of quality, and the fields that change every pixel of a picture. */
public final class QualitySubjects {
    private static final String LIT_LEVEL = "levels/01-courtyard.json";
    private static final String ORACLE = "the oracle: rays through the level, many a pixel";
    private static final String SEEN = "the oracle's picture as it is displayed";

    public static final Trade PRESETS = seen(
            "quality",
            new Trade.Text(
                    "Presets of quality",
                    "Each preset is a point of the front that the other subjects measure: fewer pixels below,"
                            + " more samples above.",
                    SEEN),
            List.of(),
            "high",
            Stream.of("low", "medium", "high", "ultra")
                    .map(preset -> new PictureSetting(Setting.of(preset), shot -> shot.ofPreset(preset)))
                    .toList());

    public static final Trade RESOLUTION = seen(
            "pictureResolution",
            new Trade.Text(
                    "Resolution of the picture",
                    "How many pixels are drawn along each side, as a share of the window's; the rest is"
                            + " interpolated. Menus, figures and prompts stay sharp.",
                    SEEN),
            List.of("pictureResolution"),
            "1",
            Stream.of("0.4", "0.5", "0.6", "0.7", "0.85", "1")
                    .map(share -> PictureSetting.of("pictureResolution", share, resolutionNote(share)))
                    .toList());

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
            new Trade.Text(
                    "Filter that scales the picture up",
                    "Three filters at four shares of the pixels along a side, in five levels of the game, whose frames"
                            + " are drawn one after the other: a filter pays if no other point of the same cost errs"
                            + " less.",
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

    public static final Trade NORMAL_MAPS = PictureSubjects.of(
            "normalMaps",
            new Trade.Text(
                    "Normal maps",
                    "Relief smaller than a triangle: joints, grain and ripples change the light. Without it surfaces"
                            + " are as smooth as their geometry.",
                    ORACLE),
            List.of("normalMaps"),
            "on",
            List.of(PictureSetting.of("normalMaps", "off", ""), PictureSetting.of("normalMaps", "on", "all presets")));

    public static final Trade BRDF = PictureSubjects.of(
            "brdf",
            new Trade.Text(
                    "Reflection of surfaces",
                    "GGX gives each roughness its highlight. Lambert reflects all light diffusely: nothing shines, and"
                            + " metal looks like paint.",
                    ORACLE),
            List.of("brdf"),
            "ggx",
            List.of(PictureSetting.of("brdf", "lambert", ""), PictureSetting.of("brdf", "ggx", "all presets")));

    public static final Trade SHADOW_FILTER = PictureSubjects.of(
            "shadowFilter",
            new Trade.Text(
                    "Filter of shadow maps",
                    "Whether one texel of a shadow map decides the light of a point, or the four around it, weighted."
                            + " One gives shadows with steps.",
                    ORACLE),
            List.of("shadowFilter"),
            "bilinear",
            List.of(
                    PictureSetting.of("shadowFilter", "nearest", ""),
                    PictureSetting.of("shadowFilter", "bilinear", "all presets")));

    private static final Trade.Text LIGHT_PARTS_TEXT = new Trade.Text(
            "Parts of light",
            "Ambient, diffuse and specular light of surfaces, each alone and all together, as a source of 2010 showed"
                    + " them.",
            ORACLE);

    public static final Trade LIGHT_PARTS = PictureSubjects.of(
                    "lightParts",
                    LIGHT_PARTS_TEXT,
                    List.of("lightParts"),
                    "all",
                    Stream.of("ambient", "diffuse", "specular", "all")
                            .map(parts ->
                                    PictureSetting.of("lightParts", parts, parts.equals("all") ? "all presets" : ""))
                            .toList())
            .in(LIT_LEVEL, "lightParts", LIGHT_PARTS_TEXT);

    private static final Trade.Text LIGHT_SHADOWS_TEXT = new Trade.Text(
            "Lamps with shadows",
            "So many lamps cast shadows at most, the most powerful ones. The light of the others goes through walls.",
            ORACLE);

    public static final Trade LIGHT_SHADOWS = PictureSubjects.of(
                    "lightShadows",
                    LIGHT_SHADOWS_TEXT,
                    List.of("lightShadows"),
                    "999",
                    Stream.of(0, 1, 2, 4, 999)
                            .map(lights ->
                                    PictureSetting.of("lightShadows", lights, lights == 999 ? "all presets" : ""))
                            .toList())
            .in(LIT_LEVEL, "lightShadows", LIGHT_SHADOWS_TEXT);

    private QualitySubjects() {}

    private static String filterNote(String filter) {
        return switch (filter) {
            case "sharp_bilinear" -> "software";
            case "edge_adaptive" -> "graphics cards";
            default -> "";
        };
    }

    private static String resolutionNote(String share) {
        return switch (share) {
            case "0.5" -> "low";
            case "0.7" -> "medium";
            case "1" -> "high and ultra";
            default -> "";
        };
    }

    private static Trade seen(
            String subject, Trade.Text text, List<String> fields, String usual, List<PictureSetting> settings) {
        return PictureSubjects.of(subject, text, fields, usual, settings, Compared.SEEN);
    }
}
