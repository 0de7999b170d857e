package nephele.app.view;

/**
 * How far the entity is from its rest before the camera, in the plane of the view: the report's "force". Movement keys
 * first move the entity alone, until the force is {@link #most} long; from then on it tows the camera on a rope of that
 * length, whatever its direction. When no key has moved it for {@link #PAUSE_SECONDS}, the camera catches up: the entity
 * stays where it is in the world and the force fades within {@link #RETURN_SECONDS}, softly at both ends.
 *
 * <p>Every phase is solved in closed form and a step ends a phase where it ends, so that one long step and many short
 * ones lead to the same place: no frame rate changes anything.
 *
 * @param right units to the right of the rest, when a key last moved the entity
 * @param ahead units along the view, likewise
 * @param most the longest force; 0 where nothing is towed, and the camera moves at once
 * @param idleSeconds since a key last moved the entity
 */
record Spring(double right, double ahead, double most, double idleSeconds) {
    static final double PAUSE_SECONDS = 0.3;
    static final double RETURN_SECONDS = 0.6;

    /** Nothing moves and nothing has. */
    static Spring atRest(double most) {
        return new Spring(0, 0, most, PAUSE_SECONDS + RETURN_SECONDS);
    }

    /**
     * What a step leads to.
     *
     * @param cameraRight units that the camera has moved to the right
     * @param cameraAhead units that the camera has moved along the view
     */
    record Step(Spring spring, double cameraRight, double cameraAhead) {}

    /** The force now, to the right. */
    double shownRight() {
        return right * share();
    }

    /** The force now, along the view. */
    double shownAhead() {
        return ahead * share();
    }

    /** @param seconds nothing happens in a time that is not positive and finite */
    Step after(double seconds, Steering steering) {
        if (!(seconds > 0 && seconds < Double.POSITIVE_INFINITY)) {
            return new Step(this, 0, 0);
        }
        return steering.moves() ? moved(seconds * steering.unitsPerSecond(), steering) : waited(seconds);
    }

    private Step waited(double seconds) {
        var later = new Spring(right, ahead, most, idleSeconds + seconds);
        return new Step(later, shownRight() - later.shownRight(), shownAhead() - later.shownAhead());
    }

    /** The entity goes {@code way} units; the camera goes as far, less what the force has changed. */
    private Step moved(double way, Steering steering) {
        double fromRight = shownRight();
        double fromAhead = shownAhead();
        double along = fromRight * steering.right() + fromAhead * steering.ahead();
        double across = fromAhead * steering.right() - fromRight * steering.ahead();
        double alone = Math.min(way, aloneUnits(along, across));
        Spring later = alone == way
                ? turned(along + way, across, steering)
                : towed(along + alone, across, way - alone, steering);
        double cameraRight = way * steering.right() - (later.right - fromRight);
        double cameraAhead = way * steering.ahead() - (later.ahead - fromAhead);
        return new Step(later, cameraRight, cameraAhead);
    }

    /** How far the entity goes along its way until the force is {@link #most} long and grows. */
    private double aloneUnits(double along, double across) {
        double half = Math.sqrt(Math.max(0, (most - across) * (most + across)));
        return Math.max(0, half - along);
    }

    /**
     * The end of a rope of fixed length that is pulled along a straight line, a tractrix: with the angle θ between rope
     * and line, dθ/ds = −sin θ / length, so tan(θ/2) falls as exp(−s / length).
     */
    private Spring towed(double along, double across, double way, Steering steering) {
        if (!(most > 0)) {
            return turned(0, 0, steering);
        }
        double length = Math.sqrt(along * along + across * across);
        double tangent = across / (length + along) * StrictMath.exp(-way / most);
        double scale = most / (1 + tangent * tangent);
        return turned(scale * (1 - tangent * tangent), scale * 2 * tangent, steering);
    }

    /** A force given along and across the steering, not idle. */
    private Spring turned(double along, double across, Steering steering) {
        double newRight = along * steering.right() - across * steering.ahead();
        double newAhead = along * steering.ahead() + across * steering.right();
        return new Spring(newRight, newAhead, most, 0);
    }

    /** How much of the force is left. */
    private double share() {
        double t = (idleSeconds - PAUSE_SECONDS) / RETURN_SECONDS;
        return t <= 0 ? 1 : t < 1 ? (1 - t) * (1 - t) * (1 + 2 * t) : 0;
    }
}
