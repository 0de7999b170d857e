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
    private static final String ORACLE = "the oracle: random walks through the cloud, as many scatterings as they"
        + " take. Flicker is the RMS change of the error from frame to frame, in linear light, while the view turns by"
        + " 0.3 pixels a frame";

    public static final Trade SCATTERING = subject(
            "cloudScattering",
            "Light scattered often in clouds",
            "Most light of a thick cloud has been scattered tens of times. The two-stream model finds it in closed"
                    + " form from the optical depths around each point, and follows small angles along the path;"
                    + " octaves repeat single scattering with less extinction and lose most of it.",
            "two_stream",
            List.of(
                    PictureSetting.of("cloudScattering", "two_stream", "all presets"),
                    PictureSetting.of("cloudScattering", "octaves", "the usual approximation")));

    public static final Trade STEP = subject(
            "cloudStep",
            "Steps through clouds",
            "How far apart the samples of a ray through a cloud are, in its cells. Long steps miss thin parts.",
            "1",
            List.of(
                    PictureSetting.of("cloudStep", "0.5", ""),
                    PictureSetting.of("cloudStep", 1, "medium, high and ultra"),
                    PictureSetting.of("cloudStep", 2, "low"),
                    PictureSetting.of("cloudStep", 4, "")));

    public static final Trade RESOLUTION = subject(
            "cloudResolution",
            "Rays through clouds",
            "How many rays are marched along each side of the picture. Fewer are interpolated; pixels whose surface is"
                    + " among the clouds are always marched on their own.",
            "0.5",
            List.of(
                    PictureSetting.of("cloudResolution", "0.25", ""),
                    PictureSetting.of("cloudResolution", "0.5", "low, medium and high"),
                    PictureSetting.of("cloudResolution", "1", "ultra")));

    public static final Trade LIGHT = subject(
            "cloudLightCell",
            "Map of the light in clouds",
            "The optical depth towards the sun and the diffuse light are found once for each cell of a map, whose edge"
                + " this is, in cells of density. Small cells take longer to make and more memory, and show shadows of"
                + " smaller lobes; a frame reads one of either size as fast.",
            "2",
            List.of(
                    PictureSetting.of("cloudLightCell", 1, ""),
                    PictureSetting.of("cloudLightCell", 2, "all presets"),
                    PictureSetting.of("cloudLightCell", 4, "")));

    public static final Trade FACING = subject(
            BILLBOARDS,
            "billboardFacing",
            new Trade.Text(
                    "Turning of flat clouds",
                    "Clouds of technique billboard are flat pictures of balls. Turned towards the eye they are the"
                            + " balls as far away; turned as the screen they grow towards the picture's edges; turned"
                            + " about an upright axis they are thin from above and below.",
                    ORACLE),
            "viewer",
            List.of(
                    PictureSetting.of("billboardFacing", "viewer", "all presets"),
                    PictureSetting.of("billboardFacing", "screen", ""),
                    PictureSetting.of("billboardFacing", "axial", ""),
                    PictureSetting.of("billboardFacing", "source", "wrong beside the axes")),
            Judged.STILL);

    public static final Trade BALL_LIGHT = subject(
            PARTICLES,
            "particleLight",
            new Trade.Text(
                    "Sunlight in clouds of balls",
                    "The tail is the two-stream model, with all light that is scattered often. Dobashi's model of 2000"
                            + " has light that is scattered once; Harris' of 2001 also light that was scattered"
                            + " forwards before, here so that it does not depend on the number of balls. Both lose"
                            + " what leaves the beam.",
                    ORACLE),
            "tail",
            List.of(
                    PictureSetting.of("particleLight", "tail", "all presets"),
                    PictureSetting.of("particleLight", "harris", ""),
                    PictureSetting.of("particleLight", "dobashi", "")),
            Judged.STILL);

    public static final Trade SHEET = sheet(
            "skyplaneShape",
            new Trade.Text(
                    "Shape of sheets of cloud",
                    "A layer that is drawn as a sheet bends around the planet as layers do. A plane, a mesh that sinks"
                            + " too fast and a hemisphere show its clouds in other directions.",
                    "the engine's own sheet around the planet"),
            "levels/samples/clouds-skyplane.json",
            List.of(
                    PictureSetting.of("skyplaneShape", "shell", "all presets"),
                    PictureSetting.of("skyplaneShape", "flat", ""),
                    PictureSetting.of("skyplaneShape", "curved", "a mesh of 17 × 17 vertices"),
                    PictureSetting.of("skyplaneShape", "dome", "")));

    public static final Trade NOISE = sheet(
            "proceduralNoise",
            new Trade.Text(
                    "Noise of procedural clouds",
                    "Octaves of gradient noise have no period and change smoothly. Three pictures of white noise that"
                        + " are enlarged and cross-faded repeat, and pulse while they fade. The skies are other ones"
                        + " of the same cover: the error says how different they are, not which one is wrong.",
                    "the engine's own gradient noise"),
            "levels/samples/clouds-procedural.json",
            List.of(
                    PictureSetting.of("proceduralNoise", "smooth", "all presets"),
                    PictureSetting.of("proceduralNoise", "source", "weights ½, ¼, ⅛"),
                    PictureSetting.of("proceduralNoise", "source_code", "weights .328, .219, .125")));

    public static final Trade SKYBOX = picture(
            "cloudSkyboxTexels",
            new Trade.Text(
                    "Texels of clouds as skyboxes",
                    "A cloud of technique skybox is drawn into pictures around one point when a level is loaded, and"
                            + " looked up afterwards. Fewer texels along a face of 90° make it soft; a frame costs the"
                            + " same.",
                    "the engine's own skybox of most texels"),
            "levels/samples/clouds-skybox.json",
            "512",
            List.of(
                    PictureSetting.of("cloudSkyboxTexels", 2048, ""),
                    PictureSetting.of("cloudSkyboxTexels", 1024, ""),
                    PictureSetting.of("cloudSkyboxTexels", 512, "all presets"),
                    PictureSetting.of("cloudSkyboxTexels", 256, "")));

    private static final String FLIGHT =
            "the engine's own frames of all rays without impostors, while the eye moves to the"
                    + " right by 16 m a frame; the worst of eight";

    public static final Trade IMPOSTORS = subject(
            PARTICLES,
            "impostors",
            new Trade.Text(
                    "Impostors of clouds of balls",
                    "A cloud of soft balls far away is drawn once and shown from that picture until the eye has moved"
                            + " so far that a part of it would be in a wrong place. Pictures are made over several"
                            + " frames; clouds that are near are drawn ball by ball.",
                    FLIGHT),
            "auto",
            List.of(
                    PictureSetting.of("impostors", "off", "ultra"),
                    PictureSetting.of("impostors", "auto", "low, medium and high")),
            Judged.FLYING);

    public static final Trade IMPOSTOR_ERROR = subject(
            PARTICLES,
            "impostorErrorPixels",
            new Trade.Text(
                    "Error of impostors",
                    "How many pixels a part of a cloud may be from its place before its picture is replaced. A smaller"
                            + " error takes more pictures, or drawing ball by ball if the eye is fast.",
                    FLIGHT),
            "1",
            List.of(
                    PictureSetting.of("impostorErrorPixels", "0.25", ""),
                    PictureSetting.of("impostorErrorPixels", "1", "all presets"),
                    PictureSetting.of("impostorErrorPixels", "4", "")),
            Judged.FLYING);

    private static final List<PictureSetting> HISTORIES = List.of(
            PictureSetting.of("cloudHistory", "none", "ultra"),
            PictureSetting.of("cloudHistory", "four_frames", "medium and high"),
            PictureSetting.of("cloudHistory", "sixteen_frames", "low"));

    public static final Trade HISTORY = subject(
            CUMULUS,
            "cloudHistory",
            new Trade.Text(
                    "Rays through clouds among frames",
                    "A frame marches one ray of each square of rays; the others show what earlier frames have seen in"
                            + " their direction. A still view loses nothing, a moving one some sharpness.",
                    "the engine's own frames of all rays, while the view turns by 0.3 pixels a frame"),
            "four_frames",
            HISTORIES,
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
        var words = new Trade.Text(title, "The same clouds by each technique that can show them.", ORACLE);
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

    /** The first setting is the usual one, and the exact one. */
    private static Trade sheet(String field, Trade.Text words, String level, List<PictureSetting> settings) {
        return picture(field, words, level, settings.get(0).setting().name(), settings);
    }

    /** The first setting is the exact one. */
    private static Trade picture(
            String field, Trade.Text words, String level, String usual, List<PictureSetting> settings) {
        return PictureSubjects.of(field, words, List.of(field), usual, settings, Compared.DISPLAY)
                .in(level, field, words);
    }

    private static Trade subject(String field, String title, String text, String usual, List<PictureSetting> settings) {
        return subject(GRID, field, new Trade.Text(title, text, ORACLE), usual, settings, Judged.STILL);
    }

    private static Trade subject(
            String level, String field, Trade.Text words, String usual, List<PictureSetting> settings, Judged judged) {
        List<Setting> named = settings.stream().map(PictureSetting::setting).toList();
        return new Trade(
                        field,
                        words,
                        List.of(field),
                        named,
                        named.stream().map(Setting::name).toList().indexOf(usual),
                        judged == Judged.STILL ? ErrorMetric.PICTURE : ErrorMetric.DISPLAYED,
                        CloudExperiment.FIGURES,
                        CostMetric.FRAME,
                        null,
                        site -> new CloudExperiment(site, settings, judged))
                .in(level, field, words);
    }
}
