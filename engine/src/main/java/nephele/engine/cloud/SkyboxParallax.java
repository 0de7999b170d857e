package nephele.engine.cloud;

import nephele.engine.level.Camera;
import nephele.engine.level.Level;

/**
 * The error of a picture of a cloud that was taken from one point and is shown to another eye in the same directions. An eye
 * that moves by t across the direction of something at distance D sees it turned by atan(t / D), which is f t / D pixels in
 * the middle of a perspective picture of w pixels that spans the angle φ: f = w / (2 tan(φ / 2)).
 *
 * @param travelMetres t, the greatest distance of an eye from the point
 * @param nearestMetres D, the least distance of an eye from the cloud; 0 if it can be inside
 */
public record SkyboxParallax(double travelMetres, double nearestMetres) {
    /** The width of a picture of which errors are told, pixels. */
    public static final int PICTURE_PIXELS = 1280;

    /** The player's vertical field of view, and the shape of the picture. */
    private static final double PLAYER_FOV_DEGREES = 60;

    private static final double ASPECT = 16.0 / 9;

    /** Returns true if an eye can be in the cloud. */
    public boolean isInside() {
        return !(nearestMetres > 0);
    }

    /**
     * Returns by how many pixels the nearest part of the cloud is displaced at most; infinite inside of it.
     *
     * @param focalPixels f
     */
    public double pixels(double focalPixels) {
        return isInside() ? Double.POSITIVE_INFINITY : focalPixels * travelMetres / nearestMetres;
    }

    /** Returns f of a level's first camera, otherwise of the player, in a picture of {@link #PICTURE_PIXELS}. */
    public static double focalPixels(Level level) {
        double tanHalfHeight = Math.tan(Math.toRadians(PLAYER_FOV_DEGREES) / 2);
        if (!level.cameras().isEmpty()) {
            Camera camera = level.cameras().get(0);
            tanHalfHeight = camera.verticalFovDegrees() > 0
                    ? Math.tan(Math.toRadians(camera.verticalFovDegrees()) / 2)
                    : Math.tan(Math.toRadians(camera.horizontalFovDegrees()) / 2) / ASPECT;
        }
        return PICTURE_PIXELS / 2.0 / (tanHalfHeight * ASPECT);
    }
}
