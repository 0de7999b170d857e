package nephele.host.named;

import java.io.PrintStream;
import java.util.List;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.sim.replay.Replay;

/** Compares the level in which a replay was recorded with the one in which it is played. */
public final class ReplayOrigin {
    private ReplayOrigin() {}

    /**
     * Checks that a replay belongs to a level.
     *
     * @param file the replay's name for messages
     * @param warnings receives a line if the level has changed since the recording
     * @throws LevelFormatException if the replay names another level
     */
    public static void require(OpenedLevel opened, String file, Replay replay, PrintStream warnings) {
        String name = opened.level().name();
        if (replay.levelName() != null && !replay.levelName().equals(name)) {
            String message = "was recorded in the level '" + replay.levelName() + "', and " + opened.file() + " is '"
                    + name + "': play it in its own level";
            throw new LevelFormatException(file, List.of(Problem.error("levelName", message)));
        }
        String sha256 = replay.levelSha256();
        if (sha256 != null && !sha256.equalsIgnoreCase(LevelJson.sha256(opened.level()))) {
            String message = opened.file() + " has changed since this was recorded: it may go another way";
            warnings.println(Problem.warning("levelSha256", message).line(file));
        }
    }
}
