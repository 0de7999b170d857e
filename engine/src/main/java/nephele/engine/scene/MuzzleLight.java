package nephele.engine.scene;

import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * The light that a shot throws from the gun's muzzle on the surfaces around; a value of the frame state. It casts no
 * shadows.
 *
 * @param place of the muzzle at the shot, metres
 * @param colour 0 or 1, the number of the shot
 * @param strength 1 at its brightest
 */
public record MuzzleLight(Vec3 place, int colour, double strength) {
    /** Distance from which on it lights nothing. */
    public static final double RANGE_METRES = 7;

    /** Radiant intensity at strength 1, as displayed on a white surface: times m². */
    public static final double INTENSITY = 3;

    /** Size of the source, which bounds the light on surfaces close to it, square metres. */
    public static final double SOURCE_SQUARE_METRES = 0.2;

    /** Fraction of the light that a surface which is black in the picture is assumed to reflect. */
    public static final double DARK_SHARE = 0.1;

    private static final double SECONDS = 0.14;
    private static final double SOFTENED_SECONDS = 0.4;
    private static final double SOFTENED_RISE_SECONDS = 0.1;
    private static final double SOFTENED_STRENGTH = 0.3;

    /** Returns the strength at this time after the shot: greatest at once, unless flashes are softened, and soon 0. */
    public static double strengthAfter(double seconds, FlashStyle style) {
        boolean isSoftened = style == FlashStyle.SOFTENED;
        double passed = seconds / (isSoftened ? SOFTENED_SECONDS : SECONDS);
        double left = 1 - passed * passed;
        if (seconds < 0 || left <= 0) {
            return 0;
        }
        double risen = isSoftened ? SOFTENED_STRENGTH * Math.min(1, seconds / SOFTENED_RISE_SECONDS) : 1;
        return risen * left * left;
    }

    /** Returns the light as displayed on a white surface that faces the muzzle; the twin of {@code muzzle.frag}. */
    public double displayed(double metres) {
        double square = metres * metres;
        double q = square / (RANGE_METRES * RANGE_METRES);
        double window = Math.max(0, 1 - q * q);
        return strength * INTENSITY * window * window / (square + SOURCE_SQUARE_METRES);
    }

    /** Returns the box outside of which it lights nothing. */
    public Aabb bounds() {
        return new Aabb(place.x(), place.y(), place.z(), place.x(), place.y(), place.z()).grown(RANGE_METRES);
    }
}
