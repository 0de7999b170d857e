package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.QualityField;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** Parameters of the drawing of a level and of views through its portals; most are judged by the difference from the reference tracer's picture. */
public final class PictureSubjects {
    private static final List<String> FIGURES = List.of("relMSE", "mean bias %", "HDR-FLIP, 99th percentile of pixels");
    private static final String REFERENCE = "the oracle: rays through the level, many a pixel";

    public static final Trade ANISOTROPY = setting(
            "anisotropy",
            REFERENCE,
            List.of(
                    PictureSetting.of("anisotropy", 1, "all presets in software"),
                    PictureSetting.of("anisotropy", 2),
                    PictureSetting.of("anisotropy", 4),
                    PictureSetting.of("anisotropy", 8),
                    PictureSetting.of("anisotropy", 16, "ultra on a graphics card")));

    private static final List<PictureSetting> OUTPUTS = List.of(
            new PictureSetting(
                    new Setting("direct", "surfaces leave their shaders as they are displayed"),
                    shot -> shot.with(Output.DIRECT)),
            new PictureSetting(
                    new Setting("hdr", "half floats first, then one tone-mapping pass"),
                    shot -> shot.with(Output.HDR)));

    public static final Trade OUTPUT = of(
            "output",
            new Trade.Text(
                    "Where the tone curve is applied",
                    "Direct output applies it in the surfaces' own shaders and saves a whole pass. What is blended"
                        + " over a picture that is display-referred already comes out too bright or too dark. So far"
                        + " only the rims of portals and the ghosts of shots are blended: elsewhere both are equal up"
                        + " to dither.",
                    "the engine's own radiance in linear light, tone-mapped in double precision"),
            List.of(),
            "direct",
            OUTPUTS,
            ComparedValues.DISPLAY);

    public static final Trade CULLING = of(
            "culling",
            PictureSubjects.text("culling", REFERENCE),
            List.of(),
            "hierarchy",
            List.of(
                    PictureSetting.of("culling", "none", "everything is drawn"),
                    PictureSetting.of("culling", "sphere", "one after the other"),
                    PictureSetting.of("culling", "hierarchy")));

    public static final Trade CULLING_OF_MANY = CULLING.in(
            "levels/bench/boxes-10000.json",
            "cullingBoxes",
            new Trade.Text(
                    "Leaving out some of ten thousand",
                    "The same among ten thousand boxes, most of them out of view.",
                    REFERENCE));

    private static final String PORTAL_TECHNIQUE_FIELD = "portalTechnique";
    private static final String PORTAL_RESOLUTION_FIELD = "portalResolution";
    private static final String PORTAL_REFERENCE = "the oracle: rays go through portals without a limit that shows";

    public static final Trade PORTAL_TECHNIQUE = setting(
            PORTAL_TECHNIQUE_FIELD,
            PORTAL_REFERENCE,
            List.of(
                    PictureSetting.of(PORTAL_TECHNIQUE_FIELD, "stencil"),
                    PictureSetting.of(PORTAL_TECHNIQUE_FIELD, "texture", "a picture of its own"),
                    PictureSetting.of(PORTAL_TECHNIQUE_FIELD, "copy", "the whole frame buffer copied, for each view"),
                    PictureSetting.of(PORTAL_TECHNIQUE_FIELD, "copy_area", "the opening's part copied")));

    public static final Trade PORTAL_BUDGET = setting(
            "viewBudget",
            PORTAL_REFERENCE,
            Stream.concat(
                            Stream.of(PictureSetting.of("viewBudget", 0, "openings stay closed")),
                            PictureSetting.all("viewBudget", 1, 2, 3, 6, 9, 12, 32).stream())
                    .toList());

    public static final Trade PORTAL_BUDGET_BETWEEN_FACING = PORTAL_BUDGET.in(
            "levels/samples/facing-portals.json",
            "viewBudgetFacing",
            new Trade.Text(
                    "Views between facing portals",
                    "The same knob where it matters most: in the sample of two portals that face each other, which"
                            + " repeat until a view is smaller than a pixel.",
                    PORTAL_REFERENCE));

    public static final Trade PORTAL_RESOLUTION = of(
            PORTAL_RESOLUTION_FIELD,
            text(PORTAL_RESOLUTION_FIELD, PORTAL_REFERENCE),
            List.of(PORTAL_RESOLUTION_FIELD),
            "stencil",
            Stream.concat(
                            Stream.of("0.25", "0.5", "0.7", "1").map(PictureSubjects::portalResolution),
                            Stream.of(PictureSetting.of(PORTAL_TECHNIQUE_FIELD, "stencil")))
                    .toList());

    private PictureSubjects() {}

    private static PictureSetting portalResolution(String fraction) {
        return new PictureSetting(Setting.of(fraction), shot -> shot.set(PORTAL_TECHNIQUE_FIELD, "texture")
                .set(PORTAL_RESOLUTION_FIELD, fraction));
    }

    /** Returns the description of a setting's subject, by its declaration. */
    static Trade.Text text(String setting, String exact) {
        var declared = PictureSetting.declared(setting).declared();
        return new Trade.Text(declared.title(), declared.about(), exact);
    }

    /** Returns the subject of a setting of quality, judged by the radiance of pictures. */
    static Trade setting(String name, String exact, List<PictureSetting> settings) {
        return setting(name, exact, settings, ComparedValues.RADIANCE);
    }

    static Trade setting(String name, String exact, List<PictureSetting> settings, ComparedValues compared) {
        return of(name, text(name, exact), List.of(name), usual(name), settings, compared);
    }

    /** Returns the subject of a setting that has no other: words each, numbers as their presets. */
    public static Trade setting(QualityField field) {
        List<String> values = field.words().isEmpty() ? numbers(field) : field.words();
        return setting(field.name(), REFERENCE, PictureSetting.all(field.name(), values.toArray()));
    }

    /** Returns the numbers of the presets; of a number that all of them share also half and twice as much, if accepted. */
    private static List<String> numbers(QualityField field) {
        if (!field.isAlternative()) {
            return Stream.of(Quality.Preset.values()).map(field::in).distinct().toList();
        }
        String usual = field.in(Quality.Preset.HIGH);
        return Stream.of(scaled(field, usual, 0.5), usual, scaled(field, usual, 2))
                .filter(number -> field.parsed(number).isPresent())
                .distinct()
                .toList();
    }

    private static String scaled(QualityField field, String number, double factor) {
        double scaled = factor * Double.parseDouble(number);
        return field.type() == int.class ? Long.toString(Math.round(scaled)) : Double.toString(scaled);
    }

    /** Returns the value of a setting in the preset {@code high}. */
    static String usual(String name) {
        return PictureSetting.declared(name).in(Quality.Preset.HIGH);
    }

    static Trade of(String subject, Trade.Text text, List<String> fields, String usual, List<PictureSetting> settings) {
        return of(subject, text, fields, usual, settings, ComparedValues.RADIANCE);
    }

    static Trade of(
            String subject,
            Trade.Text text,
            List<String> fields,
            String usual,
            List<PictureSetting> settings,
            ComparedValues compared) {
        List<String> names =
                settings.stream().map(setting -> setting.setting().name()).toList();
        return new Trade(
                subject,
                text,
                fields,
                settings.stream().map(PictureSetting::setting).toList(),
                names.indexOf(usual),
                compared.error(),
                compared == ComparedValues.RADIANCE ? FIGURES : XmlPictureExperiment.FIGURES,
                CostMetric.FRAME,
                null,
                site -> new PictureExperiment(site, settings, compared));
    }
}
