package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;

/** The clouds that a weather means. */
public final class WeatherClouds {
    private WeatherClouds() {}

    /** Returns the written clouds, followed by those of the weather. */
    public static List<Cloud> all(Environment environment) {
        List<Cloud> all = new ArrayList<>(environment.clouds());
        all.addAll(of(environment));
        return List.copyOf(all);
    }

    /** Returns the clouds of the weather alone. */
    public static List<Cloud> of(Environment environment) {
        return List.of();
    }
}
