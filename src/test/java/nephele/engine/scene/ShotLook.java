package nephele.engine.scene;

import nephele.engine.scene.FrameState.ShotEffect;

/** The opacity of a shot's light; the exact twin of {@code shot-look.glsl}. */
public final class ShotLook {
    private ShotLook() {}

    /**
     * Returns the opacity of a bolt.
     *
     * @param along fraction of the path from the gun to the surface
     * @param across −1 to 1 over the bolt's width
     * @param age fraction of its time
     */
    public static double bolt(double along, double across, double age) {
        double behind = (Math.min(age / ShotEffect.BOLT_FLIGHT, 1) - along) / ShotEffect.BOLT_TAIL;
        if (behind < 0) {
            return 0;
        }
        double after = clamp((age - ShotEffect.BOLT_FLIGHT) / (1 - ShotEffect.BOLT_FLIGHT));
        double tail = clamp(1 - behind * (1 + after));
        double narrow = 1 - across * across;
        return narrow * narrow * tail * (1 - after) * (1 - after);
    }

    /**
     * Returns the opacity of a shimmer.
     *
     * @param radius 0 in the middle, 1 at the edge
     * @param age fraction of its time
     */
    public static double shimmer(double radius, double age) {
        if (radius >= 1) {
            return 0;
        }
        double behind = (Math.sqrt(age) - radius) * 3;
        double ring = behind < 0 ? Math.max(0, 1 + 6 * behind) : 0.5 + 0.5 * Math.cos(2 * Math.PI * behind);
        double fade = (1 - age) * (1 - radius * radius);
        return ring * fade / (1 + 0.6 * Math.max(behind, 0));
    }

    private static double clamp(double x) {
        return Math.max(0, Math.min(1, x));
    }
}
