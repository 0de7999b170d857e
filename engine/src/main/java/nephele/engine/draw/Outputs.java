package nephele.engine.draw;

import nephele.engine.level.Level;
import nephele.engine.render.frame.LinearLight;
import nephele.engine.render.frame.Output;

/** Which output a level asks for when nobody else says. */
public final class Outputs {
    private Outputs() {}

    /** HDR where something in the level adds light to what is drawn, else DIRECT. */
    public static Output requiredBy(Level level) {
        return LinearLight.because(level).isPresent() ? Output.HDR : Output.DIRECT;
    }
}
