package nephele.engine.cloud.drawn;

import nephele.engine.cloud.cells.SlantedShade;

/**
 * The clouds between two times for which they are sampled.
 *
 * @param from the earlier time
 * @param to the later one
 * @param share of the time from the earlier to the later one that has passed, 0 to 1
 * @param seconds simulated time
 */
public record CloudInterval(Sample from, Sample to, double share, double seconds) {
    /**
     * The clouds at one time.
     *
     * @param shares of the sun's light on the level
     * @param sky as the middle of the level sees it
     * @param groundShare share of its light that the plain keeps under the clouds
     * @param shade that the clouds cast into the air; {@code null} without shafts
     */
    public record Sample(
            DrawnClouds clouds, SunShares shares, SkyThroughClouds sky, double groundShare, SlantedShade shade) {}

    /** Returns the share of its light that the plain keeps under the clouds. */
    public double groundShare() {
        return from.groundShare + share * (to.groundShare - from.groundShare);
    }
}
