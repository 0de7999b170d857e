package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;
import nephele.lab.trade.subject.CloudExperiment.Judged;

/** The quality fields of clouds: most on the sample of a grid, the history while the view turns. */
public final class CloudSubjects {
    private static final String GRID = "levels/samples/clouds-grid.json";
    private static final String CUMULUS = "levels/samples/clouds-cumulus.json";
    private static final String BILLBOARDS = "levels/samples/clouds-billboard.json";
    private static final String PARTICLES = "levels/samples/clouds-particles.json";
    private static final String REFERENCE = "the oracle: random walks through the cloud, as many scatterings as they"
        + " take. Flicker is the RMS change of the error from frame to frame, in linear light, while the view turns by"
        + " 0.3 pixels a frame";

    public static final Trade SCATTERING = subject(
            GRID,
            "cloudScattering",
            REFERENCE,
            List.of(
                    PictureSetting.of("cloudScattering", "two_stream"),
                    PictureSetting.of("cloudScattering", "octaves", "the usual approximation")),
            Judged.STILL);

    public static final Trade STEP =
            subject(GRID, "cloudStep", REFERENCE, PictureSetting.all("cloudStep", "0.5", 1, 2, 4), Judged.STILL);

    public static final Trade RESOLUTION = subject(
            GRID,
            "cloudResolution",
            REFERENCE,
            PictureSetting.all("cloudResolution", "0.25", "0.5", "1"),
            Judged.STILL);

    public static final Trade LIGHT =
            subject(GRID, "cloudLightCell", REFERENCE, PictureSetting.all("cloudLightCell", 1, 2, 4), Judged.STILL);

    public static final Trade FACING = subject(
            BILLBOARDS,
            "billboardFacing",
            REFERENCE,
            List.of(
                    PictureSetting.of("billboardFacing", "viewer"),
                    PictureSetting.of("billboardFacing", "screen"),
                    PictureSetting.of("billboardFacing", "axial"),
                    PictureSetting.of("billboardFacing", "source", "wrong beside the axes")),
            Judged.STILL);

    public static final Trade BALL_LIGHT = subject(
            PARTICLES,
            "particleLight",
            REFERENCE,
            PictureSetting.all("particleLight", "tail", "harris", "dobashi"),
            Judged.STILL);

    public static final Trade SHEET = displayed(
            "levels/samples/clouds-skyplane.json",
            "skyplaneShape",
            "the engine's own sheet around the planet",
            List.of(
                    PictureSetting.of("skyplaneShape", "shell"),
                    PictureSetting.of("skyplaneShape", "flat"),
                    PictureSetting.of("skyplaneShape", "curved", "a mesh of 17 × 17 vertices"),
                    PictureSetting.of("skyplaneShape", "dome")));

    public static final Trade NOISE = displayed(
            "levels/samples/clouds-procedural.json",
            "proceduralNoise",
            "the engine's own gradient noise",
            List.of(
                    PictureSetting.of("proceduralNoise", "smooth"),
                    PictureSetting.of("proceduralNoise", "source", "weights ½, ¼, ⅛"),
                    PictureSetting.of("proceduralNoise", "source_code", "weights .328, .219, .125")));

    public static final Trade SKYBOX = displayed(
            "levels/samples/clouds-skybox.json",
            "cloudSkyboxTexels",
            "the engine's own skybox of most texels",
            PictureSetting.all("cloudSkyboxTexels", 2048, 1024, 512, 256));

    private static final String FLIGHT =
            "the engine's own frames of all rays without impostors, while the eye moves to the"
                    + " right by 16 m a frame; the worst of eight";

    public static final Trade IMPOSTORS =
            subject(PARTICLES, "impostors", FLIGHT, PictureSetting.all("impostors", "off", "auto"), Judged.FLYING);

    public static final Trade IMPOSTOR_ERROR = subject(
            PARTICLES,
            "impostorErrorPixels",
            FLIGHT,
            PictureSetting.all("impostorErrorPixels", "0.25", "1", "4"),
            Judged.FLYING);

    public static final Trade HISTORY = subject(
            CUMULUS,
            "cloudHistory",
            "the engine's own frames of all rays, while the view turns by 0.3 pixels a frame",
            PictureSetting.all("cloudHistory", "none", "four_frames", "sixteen_frames"),
            Judged.TURNING);

    /** The skies of the samples, each drawn by every technique that can show it, beside the truth. */
    public static final List<Trade> SKIES = List.of(
            sky("weather-few", "Fair-weather cumulus", false),
            sky("weather-scattered", "Cumulus under thin cirrus", false),
            sky("weather-broken", "A broken sheet", false),
            sky("weather-overcast", "A closed sky", false),
            sky("weather-cirrus", "Streaks of ice", false),
            sky("weather-storm", "Towers of a storm", false),
            sky("clouds-cumulus", "Cumulus", false),
            sky("clouds-stratus", "A low sheet", false),
            sky("clouds-cumulonimbus", "One tower", true),
            sky("clouds-puffs", "A heap of puffs", true),
            sky("clouds-grid", "A heap of voxels", true),
            sky("clouds-ellipsoid", "A lens", true));

    /** Techniques compared in the level of the request. */
    public static final Trade LEVEL = skySubject("clouds", "The level's clouds", true);

    private CloudSubjects() {}

    private static Trade sky(String level, String title, boolean isFinite) {
        Trade trade = skySubject("sky-" + level, title, isFinite);
        return trade.in("levels/samples/" + level + ".json", trade.subject(), trade.text());
    }

    /** @param isFinite whether balls can show its clouds */
    private static Trade skySubject(String subject, String title, boolean isFinite) {
        List<PictureSetting> settings = new ArrayList<>();
        settings.add(technique(CloudTechnique.SKYBOX, "baked"));
        settings.add(technique(CloudTechnique.SKYPLANE, "a sheet of its columns"));
        settings.add(technique(CloudTechnique.PROCEDURAL, "a sheet of noise: other clouds of the same cover"));
        if (isFinite) {
            settings.add(technique(CloudTechnique.BILLBOARD, "flat pictures of balls"));
            settings.add(technique(CloudTechnique.PARTICLES, "soft balls"));
        }
        settings.add(technique(CloudTechnique.VOLUME, "rays marched"));
        settings.add(technique(CloudTechnique.AUTO, "what is chosen here"));
        var words = new Trade.Text(title, "The same clouds by each technique that can show them.", REFERENCE);
        return PictureSubjects.of(subject, words, List.of(), "auto", settings);
    }

    private static PictureSetting technique(CloudTechnique technique, String note) {
        String word = technique.name().toLowerCase(Locale.ROOT);
        return new PictureSetting(
                new Setting(word, note),
                shot -> shot.with(shot.level()
                        .with(
                                WeatherClouds.drawnBy(shot.level().environment(), technique),
                                shot.level().lights())));
    }

    /** Returns a setting that the engine's own picture of its first value judges. */
    private static Trade displayed(String level, String name, String exact, List<PictureSetting> settings) {
        return PictureSubjects.setting(name, exact, settings, ComparedValues.DISPLAY)
                .in(level);
    }

    private static Trade subject(
            String level, String name, String exact, List<PictureSetting> settings, Judged judged) {
        List<Setting> named = settings.stream().map(PictureSetting::setting).toList();
        return new Trade(
                        name,
                        PictureSubjects.text(name, exact),
                        List.of(name),
                        named,
                        named.stream().map(Setting::name).toList().indexOf(PictureSubjects.usual(name)),
                        judged == Judged.STILL ? ErrorMetric.PICTURE : ErrorMetric.DISPLAYED,
                        CloudExperiment.FIGURES,
                        CostMetric.FRAME,
                        null,
                        site -> new CloudExperiment(site, settings, judged))
                .in(level);
    }
}
