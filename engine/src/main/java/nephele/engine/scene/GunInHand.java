package nephele.engine.scene;

import nephele.engine.math.Vec3;

/**
 * The portal gun in the player's hand as the player's own eye sees it; a value of the frame state. Lengths and angles are
 * those of a view with {@link #FOV_DEGREES}: the gun has the same size in a picture of any field of view.
 *
 * @param place of the gun's origin from the eye in metres: right, up and back
 * @param yawRadians turn to the left, {@code pitchRadians} up and {@code rollRadians} with the right side down
 * @param secondShare 0 while the first shot's portal is next, 1 for the second's; between them while the lamp changes
 * @param flash light of a shot at the muzzle, 0 to 1
 * @param flashColour 0 or 1, the number of that shot
 */
public record GunInHand(
        Vec3 place,
        double yawRadians,
        double pitchRadians,
        double rollRadians,
        double secondShare,
        double flash,
        int flashColour) {
    /** The vertical field of view in which the gun is placed. */
    public static final double FOV_DEGREES = 54;

    private static final double TAN_HALF = StrictMath.tan(StrictMath.toRadians(FOV_DEGREES / 2));
    /** The aspect below which the gun moves towards the middle, and how far it does at most. */
    private static final double LEAST_ASPECT = 1.5;

    private static final double LEAST_SHARE = 0.7;

    /** Returns the factor on lengths to the right and up that gives the gun its size in another field of view. */
    public static double widening(double tanHalfHeight) {
        return tanHalfHeight / TAN_HALF;
    }

    /** Returns the distance of the gun's origin to the right, metres, in a picture of this aspect. */
    public double rightMetres(double aspect) {
        return place.x() * Math.max(LEAST_SHARE, Math.min(1, aspect / LEAST_ASPECT));
    }
}
