package nephele.workshop.solve;

import java.util.function.Consumer;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerState;

/**
 * A scripted solution of a level.
 *
 * @param levelFile its name below {@code levels/}
 * @param goal the middle of the dais on which the player stands at the end
 * @param play the script
 */
public record Solution(String levelFile, Vec3 goal, Consumer<ScriptedPlayer> play) {
    /** The radius of the dais at a level's goal. */
    private static final double GOAL_RADIUS_METRES = 1.25;

    private static final double GOAL_DEPTH_METRES = 0.3;

    public Replay playIn(PlacedLevel level) {
        var player = new ScriptedPlayer(level, levelFile);
        play.accept(player);
        return player.replay().recordedIn(level.level());
    }

    /** Returns true if a player stands on the goal. */
    public boolean isSolvedBy(PlayerState player) {
        double x = player.feet().x() - goal.x();
        double z = player.feet().z() - goal.z();
        return player.isGrounded()
                && StrictMath.hypot(x, z) < GOAL_RADIUS_METRES
                && Math.abs(player.feet().y() - goal.y()) < GOAL_DEPTH_METRES;
    }
}
