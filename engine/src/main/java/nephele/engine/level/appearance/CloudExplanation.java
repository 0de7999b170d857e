package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Environment.WeatherKeyframe;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.WordFormats;

/** The lines of {@code explain} about clouds: how they are drawn, and which ones a weather adds. */
public final class CloudExplanation {
    private static final Set<CloudTechnique> OF_BALLS = EnumSet.of(CloudTechnique.PARTICLES, CloudTechnique.BILLBOARD);

    private CloudExplanation() {}

    /** Returns no lines for a level without clouds and weather; each cloud of a weather is one line of JSON. */
    public static List<String> lines(Environment environment) {
        List<String> lines = new ArrayList<>();
        List<Cloud> clouds = WeatherClouds.all(environment);
        List<Cloud> written = clouds.stream()
                .filter(cloud -> cloud.technique() != CloudTechnique.AUTO)
                .toList();
        if (clouds.size() > written.size()) {
            lines.add("clouds: " + (clouds.size() - written.size()) + " drawn as volumes");
        }
        for (Cloud cloud : written) {
            boolean isDivided = OF_BALLS.contains(cloud.technique());
            boolean isLayer = cloud.extent() instanceof Cloud.Extent.Layer;
            lines.add("clouds: " + cloud.id()
                    + (isDivided && isLayer ? " as a volume, not" : "")
                    + " by technique " + WordFormats.Choice.word(cloud.technique())
                    + (isDivided && isLayer
                            ? ": because an endless layer is not divided into balls"
                            : ": because technique is written"));
        }
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
        return lines;
    }
}
