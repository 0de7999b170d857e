package nephele.workshop.solve;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;

/**
 * A scripted solution of a level.
 *
 * @param levelFile its name below {@code levels/}
 * @param goal the middle of the dais on which the player stands at the end
 * @param play the script
 */
public record Solution(String levelFile, Vec3 goal, Consumer<ScriptedPlayer> play) {
    /** The solutions of the levels that have one. */
    public static final List<Solution> ALL = List.of(
            new Solution("02-first-shot.json", new Vec3(4.1, 0.135, -13.4), Solution::firstShot),
            new Solution("03-momentum.json", new Vec3(0, -3.865, -17), Solution::momentum),
            new Solution("04-cube.json", new Vec3(4.4, 1.635, -7), Solution::cube),
            new Solution("05-above-the-clouds.json", new Vec3(640, 1893.135, -71), Solution::aboveTheClouds),
            new Solution("06-standing-stones.json", new Vec3(10, 38.185, -72), Solution::standingStones));

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

    /**
     * Writes the replay of every solution: {@code gradle solutions}.
     *
     * @param arguments the folder of the levels, default {@code levels}
     */
    public static void main(String[] arguments) throws IOException {
        Path levels = Path.of(arguments.length > 0 ? arguments[0] : "levels");
        for (Solution solution : ALL) {
            LevelFile.Opened opened = LevelFile.load(levels.resolve(solution.levelFile()));
            var replay = solution.playIn(PlacedLevel.of(opened.level(), opened.assets()));
            Path file = levels.resolve("replays").resolve(solution.levelFile());
            Files.writeString(file, replay.write());
            System.out.println(file + ": " + replay.ticks() + " ticks");
        }
    }

    /** Leaves the antechamber, places one portal nearby and one across the water, and walks through. */
    private static void firstShot(ScriptedPlayer player) {
        player.pause(0.5)
                .lookAlong(12, -3)
                .lookAlong(0, -2)
                .walkTo(0, 13)
                .doUntil(
                        PlayerInput.FORWARD,
                        now -> now.feet().z() < 11 && now.feet().x() < 5)
                .pause(0.3)
                .lookAt(new Vec3(4.1, 1.6, -13.4))
                .walkTo(2.4, 4.6)
                .pause(0.4)
                .shoot(Action.FIRE_SECOND, new Vec3(-3, 1.2, -16))
                .shoot(Action.FIRE_FIRST, new Vec3(-1, 1.2, 10))
                .walkTo(-1, 8.2)
                .lookAlong(180, -2)
                .doUntil(
                        PlayerInput.FORWARD,
                        now -> now.feet().z() < -10 && now.feet().z() > -14.2)
                .lookAt(new Vec3(4.1, 1.2, -13.4))
                .walkTo(4.1, -13.4)
                .lookAlong(0, -2)
                .pause(1);
    }

    /** Places one portal high on the wall behind and one on the floor of the shaft, and steps over the edge. */
    private static void momentum(ScriptedPlayer player) {
        player.pause(0.5)
                .lookAt(new Vec3(0, -3, -17))
                .pause(0.4)
                .walkTo(0, 1.2)
                .shoot(Action.FIRE_FIRST, new Vec3(0, 3.5, 6))
                .walkTo(0, 0.3)
                .shoot(Action.FIRE_SECOND, new Vec3(0, -12, -3.4))
                .doUntil(PlayerInput.NONE.walking(55, 0), now -> !now.isGrounded())
                .doUntil(PlayerInput.NONE, now -> now.isGrounded())
                .pause(0.8)
                .walkTo(0, -17)
                .lookAlong(0, -2)
                .pause(1);
    }

    /**
     * Places one portal through the grille and one behind. The crate is carried through, put down before the terrace
     * and climbed.
     */
    private static void cube(ScriptedPlayer player) {
        player.pause(0.5)
                .walkTo(-0.08, 3.5)
                .lookAt(new Vec3(4.4, 2.6, -7))
                .pause(0.5)
                .shoot(Action.FIRE_SECOND, new Vec3(-1.65, 1.1, -11))
                .shoot(Action.FIRE_FIRST, new Vec3(-1.65, 1.1, 9))
                .walkTo(1.3, 5.2)
                .lookAt(new Vec3(2.7, 0.4, 4.4))
                .press(Action.CARRY)
                .pause(0.4)
                .lookAlong(60, -8)
                .walkTo(-1.65, 6.4)
                .lookAlong(180, -8)
                .doUntil(
                        PlayerInput.FORWARD,
                        now -> now.feet().z() < -3 && now.feet().z() > -8)
                .walkTo(1.15, -6)
                .lookAlong(-90, -8)
                .lookAlong(-90, -50)
                .pause(0.5)
                .press(Action.CARRY)
                .pause(0.5)
                .doUntil(PlayerInput.NONE.walking(-60, 0), now -> now.feet().x() < 0.1)
                .lookAlong(-90, -16)
                .doUntil(PlayerInput.FORWARD, now -> now.feet().x() > 0.75)
                .hold(PlayerInput.FORWARD.holding(Action.JUMP), 0.3)
                .doUntil(PlayerInput.FORWARD, now -> now.feet().x() > 1.7)
                .doUntil(PlayerInput.NONE, now -> now.isGrounded())
                .pause(0.3)
                .hold(PlayerInput.FORWARD.holding(Action.JUMP), 0.5)
                .doUntil(PlayerInput.FORWARD, now -> now.feet().x() > 3)
                .walkTo(4.4, -7)
                .lookAlong(-90, 2)
                .pause(1);
    }

    /**
     * Places one portal across the gap and one behind, follows the lamps through the cloud and falls through the deck a
     * first time. From the landing's floor to its wall leads the second pair; the high window leads back to the well.
     */
    private static void aboveTheClouds(ScriptedPlayer player) {
        player.pause(0.6)
                .lookAt(new Vec3(621, 2013.4, 26.3))
                .pause(0.3)
                .walkTo(618.2, 62.6)
                .shoot(Action.FIRE_SECOND, new Vec3(621, 2013.4, 26.26))
                .shoot(Action.FIRE_FIRST, new Vec3(624.24, 2013.4, 63))
                .walkTo(623, 63)
                .doUntil(PlayerInput.FORWARD, now -> now.feet().z() < 40)
                .walkTo(622.6, 29)
                .walkTo(638.6, 29)
                .walkTo(640, 26.4)
                .walkTo(640, 7.5)
                .lookAt(new Vec3(645.4, 2016, -6))
                .pause(0.6);
        fallDownTheWell(player, 3.4);
        player.doUntil(PlayerInput.NONE, now -> now.isGrounded())
                .pause(0.5)
                .walkTo(640, -1.5)
                .lookAt(new Vec3(640, 1894, -60))
                .pause(0.5)
                .shoot(Action.FIRE_SECOND, new Vec3(640, 1904, 2))
                .shoot(Action.FIRE_FIRST, new Vec3(640, 1906.6, 8))
                .walkTo(643.4, 2)
                .walkTo(644.3, 6.4)
                .lookAlong(180, 0)
                .doUntil(PlayerInput.FORWARD, now -> now.feet().y() > 1990 && now.isGrounded())
                .walkTo(642.4, -2.5);
        fallDownTheWell(player, 0.6);
        player.lookAlong(0, -80)
                .doUntil(PlayerInput.NONE, now -> now.isGrounded())
                .pause(0.5)
                .walkTo(640, -71)
                .lookAlong(0, -2)
                .pause(1);
    }

    /** Walks to a place beside the well and slowly over its rim. */
    private static void fallDownTheWell(ScriptedPlayer player, double fromZ) {
        player.walkTo(640, fromZ)
                .lookAt(new Vec3(640, 2012, 2))
                .doUntil(PlayerInput.NONE.walking(45, 0), now -> !now.isGrounded());
    }

    /**
     * Places portals in the temple across the gorge and in the gate, climbs the hill, places one on the leaning stone and
     * one in the basin below the cliff, and falls through the eye of the tongue.
     */
    private static void standingStones(ScriptedPlayer player) {
        player.pause(0.6)
                .walkTo(3.5, 57.5)
                .lookAt(new Vec3(8, 19, -27))
                .walkTo(3.2, 41)
                .shoot(Action.FIRE_SECOND, new Vec3(8, 18.96, -27.65))
                .walkTo(5.5, 57.5)
                .shoot(Action.FIRE_FIRST, new Vec3(7.2, 17.6, 54.13))
                .walkTo(7.2, 56.2)
                .lookAlong(0, -4)
                .doUntil(
                        PlayerInput.FORWARD,
                        now -> now.feet().z() < -20 && now.feet().z() > -26.5)
                .walkTo(8, -15)
                .walkTo(-26, -17)
                .walkTo(-46, -24)
                .walkTo(-58, -50)
                .walkTo(-49.5, -63)
                .walkTo(-40, -69)
                .walkTo(-40.2, -72)
                .shoot(Action.FIRE_FIRST, new Vec3(-45.4, 41.55, -72))
                .walkTo(-34.1, -69.2)
                .shoot(Action.FIRE_SECOND, new Vec3(-26.1, 16.15, -71.6))
                .walkTo(-38.2, -71)
                .walkTo(-37.4, -72)
                .walkTo(-29, -72)
                .lookAlong(-90, -40)
                .doUntil(PlayerInput.NONE.walking(40, 0), now -> !now.isGrounded())
                .doUntil(PlayerInput.NONE, now -> now.isGrounded())
                .pause(0.5)
                .walkTo(10, -72)
                .lookAlong(0, -2)
                .pause(1);
    }
}
