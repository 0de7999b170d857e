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
        assertEquals(Optional.of("too large"), Loading.problemLine(new GlException("too large\nby far")));
        assertEquals(
                Optional.of("no float targets"), Loading.problemLine(new GlUnavailableException("no float targets")));
        assertEquals(
                Optional.of("a.png: is cut; mend it"),
                Loading.problemLine(new AssetException("a.png", "is cut", "mend it")));
        assertEquals(Optional.empty(), Loading.problemLine(new IllegalStateException("a bug")));
    }
}
