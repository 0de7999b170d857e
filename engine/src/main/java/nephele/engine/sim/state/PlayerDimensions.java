package nephele.engine.sim.state;

import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.math.Vec3;

/** The dimensions and abilities of the player, in metres and seconds. */
public final class PlayerDimensions {
    /** The capsule's radius, metres. */
    public static final double RADIUS_METRES = 0.3;

    public static final double MASS_KILOGRAMS = 80;
    /** The gravitational acceleration, m/s². */
    public static final double GRAVITY_METRES_PER_SECOND_SQUARED = 9.81;
    /** The speed of walking, m/s; those of running and crouching follow. */
    public static final double WALK_METRES_PER_SECOND = 4;

    public static final double RUN_METRES_PER_SECOND = 6;
    public static final double CROUCH_METRES_PER_SECOND = 2;
    /** The rise of the feet in a jump, metres. */
    public static final double JUMP_METRES = 1;
    /** The height of the highest step that is walked up or down, metres. */
    public static final double STEP_METRES = 0.4;
    /**
     * The least upward component of a unit normal of walkable ground: cos 50°, less 1e-9 so that a slope of exactly 50°
     * counts.
     */
    public static final double MIN_GROUND_NORMAL_Y = StrictMath.cos(Math.toRadians(50)) - 1e-9;
    /** The walking velocity approaches the move intent by 1 − exp(−k t) with this k. */
    public static final double GROUND_RATE_PER_SECOND = 12;

    /** The acceleration of steering in the air, m/s². */
    public static final double AIR_METRES_PER_SECOND_SQUARED = 8;

    public static final double EYE_RATE_PER_SECOND = 15;
    /** A player inside a solid is pushed out by at most this in a tick. */
    public static final double DEPENETRATION_METRES_PER_TICK = 0.02;

    private PlayerDimensions() {}

    /** The posture: standing or crouched. */
    public enum Stance {
        STANDING(1.8, 1.65),
        CROUCHED(1.1, 0.95);

        private final double heightMetres;
        private final double eyeMetres;
        private final RoundedHull shape;

        Stance(double heightMetres, double eyeMetres) {
            this.heightMetres = heightMetres;
            this.eyeMetres = eyeMetres;
            shape = RoundedHull.uprightCapsule(RADIUS_METRES, heightMetres);
        }

        /** Returns the capsule's height. */
        public double heightMetres() {
            return heightMetres;
        }

        /** Returns the height of the eye above the feet, at rest. */
        public double eyeMetres() {
            return eyeMetres;
        }

        /** Returns the upright capsule, around its centre. */
        public RoundedHull shape() {
            return shape;
        }

        /** Returns the capsule along a body axis of unit length, around its centre. */
        public RoundedHull shape(Vec3 up) {
            return up.equals(Tilt.UPRIGHT.up())
                    ? shape
                    : RoundedHull.capsule(up.scaled(heightMetres / 2 - RADIUS_METRES), RADIUS_METRES);
        }

        /**
         * Returns the height of the capsule's centre above the feet. Feet on a floor are at the floor's height; the
         * capsule keeps the skin's distance from it.
         */
        public double centreAboveFeet() {
            return heightMetres / 2 + Sweep.SKIN_METRES;
        }
    }
}
