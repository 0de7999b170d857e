package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import nephele.engine.asset.AssetException;
import nephele.engine.render.gl.GlUnavailableException;
import nephele.engine.render.gl.shader.GlException;
import org.junit.jupiter.api.Test;

class LoadProblemTest {
    @Test
    void graphicsAndAssetsAreToldInOneLineAndABugIsNot() {
        assertEquals(Optional.of("too large"), LoadProblem.line(new GlException("too large\nby far")));
        assertEquals(Optional.of("no float targets"), LoadProblem.line(new GlUnavailableException("no float targets")));
        assertEquals(
                Optional.of("a.png: is cut; mend it"),
                LoadProblem.line(new AssetException("a.png", "is cut", "mend it")));
        assertEquals(Optional.empty(), LoadProblem.line(new IllegalStateException("a bug")));
    }
}
