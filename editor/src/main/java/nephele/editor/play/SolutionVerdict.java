package nephele.editor.play;

import java.util.Optional;
import nephele.engine.math.Vec3;

/**
 * The result of a recorded solution in the present level.
 *
 * @param exit the first entry of an exit, if any
 * @param deviation where the replay first differs from the recording, or misses the exit; empty if nowhere
 */
public record SolutionVerdict(Optional<AtExit> exit, Optional<Deviation> deviation) {
    /** The level's end: its tick, the simulated time since the start, and the number of portals shot until then. */
    public record AtExit(long tick, double seconds, int portals) {}

    /**
     * The first difference from the recording.
     *
     * @param tick of the simulation
     * @param seconds simulated time since the start
     * @param place the player's feet in the present level
     * @param expected the player's feet in the recording; the same as {@code place} if it does not say
     */
    public record Deviation(Cause cause, long tick, double seconds, Vec3 place, Vec3 expected) {}

    /** The kinds of differences. */
    public enum Cause {
        /** The player is more than a centimetre from the recorded place. */
        ELSEWHERE,
        /** A shot places no portal that placed one. */
        PORTAL_REFUSED,
        /** The replay ends before an exit is reached. */
        EXIT_NOT_REACHED
    }

    /** Returns true if the solution still reaches the exit. */
    public boolean isSolved() {
        return exit.isPresent();
    }
}
