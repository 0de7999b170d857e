package nephele.app.play;

import java.util.Optional;
import nephele.engine.asset.AssetException;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.render.gl.GlUnavailableException;
import nephele.engine.render.gl.shader.GlException;

/** The message for a level that cannot be loaded. */
final class LoadProblem {
    private LoadProblem() {}

    /** Returns one line for failures after which the game continues; empty for a bug. */
    static Optional<String> line(RuntimeException failure) {
        boolean goesOn = failure instanceof LevelFormatException
                || failure instanceof AssetException
                || failure instanceof GlUnavailableException
                || failure instanceof GlException;
        return goesOn
                ? Optional.of(failure.getMessage().lines().findFirst().orElse("the level can't be loaded"))
                : Optional.empty();
    }
}
