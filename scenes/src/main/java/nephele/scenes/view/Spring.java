package nephele.scenes.view;

/**
 * The displacement ("force") of the entity from its rest before the camera, in the plane of the view. Movement keys
 * first move the entity alone, until the displacement is {@link #most} long; from then on the entity tows the camera on
 * a rope of that length, whatever its direction. After {@link #PAUSE_SECONDS} without a movement key the camera catches
 * up: the entity stays where it is in the world and the displacement fades within {@link #RETURN_SECONDS}, with zero
 * slope at both ends.
 *
 * <p>Every phase is solved in closed form, and a step is split where a phase ends, so one long step and many short ones
 * give the same result: the motion is independent of the frame rate.
 *
 * @param right units to the right of the rest, when a key last moved the entity
 * @param ahead units along the view, when a key last moved the entity
 * @param most the greatest displacement, units; 0 if nothing is towed, and the camera moves at once
 * @param idleSeconds the time since a key last moved the entity
 */
public record Spring(double right, double ahead, double most, double idleSeconds) {
    static final double PAUSE_SECONDS = 0.3;
    static final double RETURN_SECONDS = 0.6;

    /** Returns a spring at rest, without any earlier motion. */
    static Spring atRest(double most) {
        return new Spring(0, 0, most, PAUSE_SECONDS + RETURN_SECONDS);
    }

    /**
     * The result of a step.
     *
     * @param cameraRight units that the camera has moved to the right
     * @param cameraAhead units that the camera has moved along the view
     */
    record Step(Spring spring, double cameraRight, double cameraAhead) {}

    /** Returns the present displacement to the right, units. */
    public double currentRight() {
        return right * fraction();
    }

    /** Returns the present displacement along the view, units. */
    double currentAhead() {
        return ahead * fraction();
    }

    /** @param seconds a time that is not positive and finite changes nothing */
    Step after(double seconds, Steering steering) {
        if (!(seconds > 0 && seconds < Double.POSITIVE_INFINITY)) {
            return new Step(this, 0, 0);
        }
        return steering.moves() ? moved(seconds * steering.unitsPerSecond(), steering) : waited(seconds);
    }

    private Step waited(double seconds) {
        var later = new Spring(right, ahead, most, idleSeconds + seconds);
        return new Step(later, currentRight() - later.currentRight(), currentAhead() - later.currentAhead());
    }

    /** Moves the entity by {@code units}; the camera moves by the same, less the change of the displacement. */
    private Step moved(double units, Steering steering) {
        double fromRight = currentRight();
        double fromAhead = currentAhead();
        double along = fromRight * steering.right() + fromAhead * steering.ahead();
        double across = fromAhead * steering.right() - fromRight * steering.ahead();
        double alone = Math.min(units, aloneUnits(along, across));
        Spring later = alone == units
                ? turned(along + units, across, steering)
                : towed(along + alone, across, units - alone, steering);
        double cameraRight = units * steering.right() - (later.right - fromRight);
        double cameraAhead = units * steering.ahead() - (later.ahead - fromAhead);
        return new Step(later, cameraRight, cameraAhead);
    }

    /** Returns the distance that the entity moves before the displacement is {@link #most} long and would grow. */
    private double aloneUnits(double along, double across) {
        double half = Math.sqrt(Math.max(0, (most - across) * (most + across)));
        return Math.max(0, half - along);
    }

    /**
     * Tows the end of a rope of fixed length along a straight line, a tractrix: with the angle θ between rope and line,
     * dθ/ds = −sin θ / length, so tan(θ/2) falls as exp(−s / length).
     */
    private Spring towed(double along, double across, double units, Steering steering) {
        if (!(most > 0)) {
            return turned(0, 0, steering);
        }
        double length = Math.sqrt(along * along + across * across);
        double tangent = across / (length + along) * StrictMath.exp(-units / most);
        double scale = most / (1 + tangent * tangent);
        return turned(scale * (1 - tangent * tangent), scale * 2 * tangent, steering);
    }

    /** Returns a spring, not idle, with a displacement given along and across the steering. */
    private Spring turned(double along, double across, Steering steering) {
        double newRight = along * steering.right() - across * steering.ahead();
        double newAhead = along * steering.ahead() + across * steering.right();
        return new Spring(newRight, newAhead, most, 0);
    }

    /** Returns the remaining fraction of the displacement. */
    private double fraction() {
        double t = (idleSeconds - PAUSE_SECONDS) / RETURN_SECONDS;
        return t <= 0 ? 1 : t < 1 ? (1 - t) * (1 - t) * (1 + 2 * t) : 0;
    }
}
