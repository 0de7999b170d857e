package nephele.engine.sim;

import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;

/** The player's measures and abilities; metres, seconds. */
public final class PlayerBody {
    public static final double RADIUS = 0.3;
    public static final double MASS_KILOGRAMS = 80;
    public static final double GRAVITY = 9.81;
    public static final double WALK_SPEED = 4;
    public static final double RUN_SPEED = 6;
    public static final double CROUCH_SPEED = 2;
    public static final double JUMP_HEIGHT = 1;
    public static final double STEP_HEIGHT = 0.4;
    /** The cosine of 50°, a hair more lenient so that a slope of exactly 50° holds. */
    public static final double STEEPEST_GROUND_UP = StrictMath.cos(Math.toRadians(50)) - 1e-9;
    /** Walking speed approaches what is asked for by 1 − exp(−k t) with this k. */
    static final double GROUND_RATE_PER_SECOND = 12;

    static final double AIR_ACCELERATION = 8;
    static final double EYE_RATE_PER_SECOND = 15;
    /** A player inside a solid is pushed out no faster than this in a tick. */
    static final double RECOVERY_METRES_PER_TICK = 0.02;

    private PlayerBody() {}

    /** Upright or crouched. */
    public enum Stance {
        STANDING(1.8, 1.65),
        CROUCHED(1.1, 0.95);

        private final double heightMetres;
        private final double eyeMetres;
        private final RoundedHull shape;

        Stance(double heightMetres, double eyeMetres) {
            this.heightMetres = heightMetres;
            this.eyeMetres = eyeMetres;
            shape = RoundedHull.uprightCapsule(RADIUS, heightMetres);
        }

        public double heightMetres() {
            return heightMetres;
        }

        /** The eye above the feet, at rest. */
        public double eyeMetres() {
            return eyeMetres;
        }

        public RoundedHull shape() {
            return shape;
        }

        /** The capsule's centre above the feet. Feet on a floor are at its height; the capsule hovers by the skin. */
        public double centreAboveFeet() {
            return heightMetres / 2 + Sweep.SKIN_METRES;
        }
    }
}
