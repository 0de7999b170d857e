package nephele.host.playthrough;

/**
 * The state of the crosshair.
 *
 * @param right position at which a shot would hit, in points from the middle of the picture; likewise {@code down}
 * @param first result of the first shot, {@code null} without a gun; likewise {@code second}
 */
public record CrosshairState(double right, double down, Half first, Half second) {
    public static final CrosshairState MIDDLE = new CrosshairState(0, 0, null, null);

    /** Whether a shot would open the portal at the place aimed at. */
    public enum Shot {
        OPENS,
        REFUSED
    }

    /**
     * The half of the crosshair for one shot.
     *
     * @param isMade whether the shot's portal exists already
     * @param unevenMillimetres by how much the ground aimed at is uneven, if the shot is refused for that, otherwise 0
     */
    public record Half(boolean isMade, Shot shot, long unevenMillimetres) {}
}
