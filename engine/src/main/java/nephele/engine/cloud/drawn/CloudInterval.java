package nephele.engine.cloud.drawn;

import java.util.List;
import nephele.engine.cloud.cells.SlantedShade;

/**
 * The clouds between two times for which they are sampled.
 *
 * @param from the earlier time
 * @param to the later one
 * @param fraction of the time from the earlier to the later one that has passed, 0 to 1
 * @param seconds simulated time
 */
public record CloudInterval(Sample from, Sample to, double fraction, double seconds) {
    /**
     * The clouds at one time.
     *
     * @param clouds all of the level
     * @param sun what they leave of its light on the level
     * @param sky as the middle of the level sees it
     * @param groundFraction of its light that the plain keeps under the clouds
     * @param shade that the clouds cast into the air; {@code null} without shafts
     */
    public record Sample(
            List<DrawnCloud> clouds,
            SunThroughClouds sun,
            SkyThroughClouds sky,
            double groundFraction,
            SlantedShade shade) {}

    /** Returns the fraction of its light that the plain keeps under the clouds. */
    public double groundFraction() {
        return from.groundFraction + fraction * (to.groundFraction - from.groundFraction);
    }
}
