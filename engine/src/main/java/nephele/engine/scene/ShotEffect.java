package nephele.engine.scene;

import nephele.engine.math.Vec3;

/**
 * The short light of a shot; a value of the frame state.
 *
 * @param kind what is drawn
 * @param colour 0 or 1, the number of the shot
 * @param age share of its duration that has passed, 0 to 1
 * @param from where a bolt begins, metres; the place of a shimmer
 * @param to where a bolt ends; of a shimmer a metre from its place along the surface's normal
 */
public record ShotEffect(Kind kind, int colour, double age, Vec3 from, Vec3 to) {
    /** The effects. */
    public enum Kind {
        /** A streak from the gun to the surface. */
        BOLT,
        /** Rings on a surface that takes no portal. */
        SHIMMER
    }
}
