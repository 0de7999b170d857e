package nephele.engine.choice;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import nephele.engine.choice.TechniqueChoice.Candidate;
import nephele.engine.cloud.SkyboxParallax;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Environment.WeatherKeyframe;
import nephele.engine.level.Weather;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.WordFormats;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.sim.reach.EyeReach;

/** The lines of {@code explain} about clouds: how each is drawn, and why, and which ones a weather adds. */
public final class CloudExplanation {
    private static final Set<CloudTechnique> OF_BALLS = EnumSet.of(CloudTechnique.PARTICLES, CloudTechnique.BILLBOARD);

    private CloudExplanation() {}

    /** Returns no lines for a level without clouds and weather; each cloud of a weather is one line of JSON. */
    public static List<String> lines(PlacedLevel placed) {
        Environment environment = placed.level().environment();
        List<String> lines = new ArrayList<>();
        if (!WeatherClouds.all(environment).isEmpty()) {
            var chosen = ChosenTechniques.of(placed);
            for (int i = 0; i < chosen.clouds().size(); i++) {
                Cloud cloud = chosen.clouds().get(i);
                TechniqueChoice choice = chosen.choices().get(i);
                lines.add(choice == null ? written(cloud) + limits(placed, cloud) : chosen(cloud, choice));
            }
        }
        weather(environment, lines);
        return lines;
    }

    private static String written(Cloud cloud) {
        boolean isShown = !(OF_BALLS.contains(cloud.technique()) && cloud.extent() instanceof Cloud.Extent.Layer);
        return "clouds: " + cloud.id()
                + (isShown ? "" : " as a volume, not")
                + " by technique " + word(cloud.technique())
                + (isShown ? ": because technique is written" : ": because an endless layer is not divided into balls");
    }

    /** Returns what is wrong with a skybox. */
    private static String limits(PlacedLevel placed, Cloud cloud) {
        if (cloud.technique() != CloudTechnique.SKYBOX) {
            return "";
        }
        EyeReach reach = EyeReach.of(placed.level(), placed.statics());
        Aabb bounds = EyeReach.bounds(cloud.extent());
        EyeReach.Part nearest = reach.nearest(bounds);
        if (nearest == null) {
            return "; without a player the eye can be anywhere";
        }
        var parallax = new SkyboxParallax(
                reach.farthestMetres(reach.bounds().centre()), EyeReach.metresBetween(nearest.box(), bounds));
        return parallax.isInside()
                ? "; wrong, since an eye can be in it " + nearest.means().words()
                : text(
                        "; %s pixels of parallax for an eye that moves %s m (%d pixels wide); no surface can be in it",
                        number(parallax.pixels(SkyboxParallax.focalPixels(placed.level()))),
                        number(parallax.travelMetres()),
                        SkyboxParallax.PICTURE_PIXELS);
    }

    private static String chosen(Cloud cloud, TechniqueChoice choice) {
        Candidate chosen = choice.chosen();
        Cloud.Tolerance tolerance = cloud.tolerance();
        String allowed =
                text("%s %% and %s pixels", number(tolerance.maxErrorPercent()), number(tolerance.maxErrorPixels()));
        String verdict = choice.inside()
                ? "the cheapest within the allowed " + allowed
                : "the least of all, none is within the allowed " + allowed;
        if (choice.situation().nearest() == null) {
            return "clouds: " + cloud.id() + " by technique " + word(chosen.technique())
                    + ": because without a player the eye can be anywhere";
        }
        if (chosen.equals(TechniqueChoice.UNMEASURED)) {
            return "clouds: " + cloud.id() + " by technique " + word(chosen.technique())
                    + ": because the errors of such clouds are not measured";
        }
        return "clouds: " + cloud.id() + " by technique " + word(chosen.technique()) + ": because "
                + place(choice.situation()) + "; error " + error(chosen) + ", " + verdict
                + (choice.runnerUp() == null
                        ? ""
                        : "; next " + word(choice.runnerUp().technique()) + " with " + error(choice.runnerUp()));
    }

    private static String place(CloudSituation at) {
        String seen = text(
                "optical depth %s, %s degrees high, sun at %s degrees",
                number(at.opticalDepth()), number(at.angularDegrees()), number(at.sunDegrees()));
        String how = at.nearest().means().words();
        return at.distanceMetres() <= 0
                ? "the eye can be inside of it " + how + " (" + seen + ")"
                : text(
                        "the eye comes to %s m of it %s, %s m from the middle of its places (%s%s)",
                        number(at.distanceMetres()),
                        how,
                        number(at.travelMetres()),
                        seen,
                        at.moves() ? ", moving" : "");
    }

    private static String error(Candidate of) {
        return text("%s %% and %s pixels", number(of.errorPercent()), number(of.errorPixels()));
    }

    private static void weather(Environment environment, List<String> lines) {
        for (WeatherKeyframe keyframe : environment.weatherKeyframes()) {
            lines.add("environment.weatherKeyframes: " + WordFormats.Choice.word(keyframe.weather()) + " from "
                    + keyframe.timeSeconds() + " s on");
        }
        if (environment.weather() != null) {
            List<Cloud> meant = WeatherClouds.of(environment.weather(), environment.weatherSeed());
            lines.add("environment.weather: " + WordFormats.Choice.word(environment.weather()) + " with weatherSeed "
                    + environment.weatherSeed() + " means "
                    + (meant.isEmpty() ? "no clouds" : "these environment.clouds:"));
            meant.forEach(cloud -> lines.add(LevelJson.line(cloud)));
        }
        if (environment.weather() == Weather.STORM && environment.lightning() == null) {
            lines.add("environment.weather: storm may also have environment.lightning and emitters of kind rain");
        }
    }

    private static String word(CloudTechnique technique) {
        return WordFormats.Choice.word(technique);
    }

    /** Returns a number with three digits or, if it is large, none behind the point. */
    private static String number(double value) {
        double digits = Math.abs(value) >= 100 ? 1 : Math.abs(value) >= 10 ? 10 : 100;
        double rounded = Math.rint(value * digits) / digits;
        return rounded == Math.rint(rounded) ? text("%.0f", rounded) : Double.toString(rounded);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
