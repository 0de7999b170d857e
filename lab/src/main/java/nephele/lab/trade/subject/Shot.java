package nephele.lab.trade.subject;

import java.util.LinkedHashMap;
import java.util.Map;
import nephele.engine.level.Level;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.frame.Output;
import nephele.host.draw.QualityChoice;

/**
 * The level, output and quality of a picture.
 *
 * @param preset of quality
 * @param set changes to the preset, in the form of {@code --set}
 */
record Shot(Level level, Output output, String preset, Map<String, String> set) {
    /** Returns a shot of quality high in which each frame is complete in itself. */
    static Shot high(Level level, Output output) {
        return new Shot(level, output, "high", Map.of("antialiasing", "none", "pictureResolution", "1"));
    }

    Shot set(String key, Object value) {
        Map<String, String> more = new LinkedHashMap<>(set);
        more.put(key, value.toString());
        return new Shot(level, output, preset, Map.copyOf(more));
    }

    /** Returns a shot with another preset, without changes to it. */
    Shot ofPreset(String other) {
        return new Shot(level, output, other, Map.of());
    }

    Shot with(Level changed) {
        return new Shot(changed, output, preset, set);
    }

    Shot with(Output changed) {
        return new Shot(level, changed, preset, set);
    }

    RenderSettings settings(boolean software) {
        return new QualityChoice(preset, set).settings(output, software);
    }
}
