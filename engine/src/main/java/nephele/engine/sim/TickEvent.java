package nephele.engine.sim;

/**
 * Something that happened in a tick and that a player sees or hears.
 *
 * @param subject the shot (0 or 1) or the body
 */
public record TickEvent(Kind kind, int subject) {
    /** What happened. */
    public enum Kind {
        PORTAL_OPENED,
        PORTAL_REFUSED,
        PICKED_UP,
        DROPPED,
        THROWN,
        NOTHING_IN_REACH,
        TOO_HEAVY
    }

    long hash(long seed) {
        return StateHash.join(StateHash.join(seed, kind.ordinal()), subject);
    }
}
