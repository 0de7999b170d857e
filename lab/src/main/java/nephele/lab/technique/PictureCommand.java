package nephele.lab.technique;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.host.draw.QualityChoice;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;

/**
 * A picture of a page, by the arguments with which {@code render} draws it.
 *
 * @param caption HTML; may be empty
 * @param words the arguments
 * @param level file of a level
 * @param options by name, such as {@code --fov}
 * @param set changes of the quality high
 */
record PictureCommand(
        String caption, String words, String level, Map<String, String> options, Map<String, String> set) {
    /** @param line the caption and a bar if there is one, then the arguments */
    static PictureCommand of(String line) {
        int bar = line.lastIndexOf(" | ");
        String caption = bar < 0 ? "" : line.substring(0, bar);
        String words = bar < 0 ? line.trim() : line.substring(bar + 3).trim();
        String[] parts = words.split("\\s+");
        Map<String, String> options = new LinkedHashMap<>();
        Map<String, String> set = new LinkedHashMap<>();
        for (int i = 1; i + 1 < parts.length; i += 2) {
            String value = parts[i + 1];
            if (parts[i].equals("--set")) {
                set.put(value.substring(0, value.indexOf('=')), value.substring(value.indexOf('=') + 1));
            } else {
                options.put(parts[i], value);
            }
        }
        return new PictureCommand(caption, words, parts[0], options, set);
    }

    /** Returns the level with its clouds drawn by the technique. */
    Level drawn(Level written) {
        String technique = options.get("--technique");
        return technique == null
                ? written
                : written.with(
                        WeatherClouds.drawnBy(
                                written.environment(), CloudTechnique.valueOf(technique.toUpperCase(Locale.ROOT))),
                        written.lights());
    }

    View view(OpenedLevel opened, double aspect) {
        if (options.containsKey("--eye")) {
            Double fov = options.containsKey("--fov") ? Double.valueOf(options.get("--fov")) : null;
            return Viewpoints.between(place("--eye"), place("--target"), fov, aspect);
        }
        String camera = options.get("--camera");
        return camera == null
                ? Viewpoints.standard(opened.level(), opened.file(), aspect).apply(0)
                : Viewpoints.named(opened.level(), opened.file(), camera, aspect)
                        .apply(0);
    }

    double seconds() {
        return Double.parseDouble(options.getOrDefault("--time", "0"));
    }

    QualityChoice quality() {
        return new QualityChoice(options.getOrDefault("--quality", "high"), set);
    }

    private Vec3 place(String option) {
        String[] numbers = options.get(option).split(",");
        return new Vec3(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]), Double.parseDouble(numbers[2]));
    }
}
