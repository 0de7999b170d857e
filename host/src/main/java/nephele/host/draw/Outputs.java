package nephele.host.draw;

import nephele.engine.level.Level;
import nephele.engine.level.appearance.LinearLight;
import nephele.engine.render.frame.Output;

/** Chooses the default output of a level. */
public final class Outputs {
    private Outputs() {}

    /** Returns HDR if something in the level adds light to the image, otherwise DIRECT. */
    public static Output defaultFor(Level level) {
        return LinearLight.because(level).isPresent() ? Output.HDR : Output.DIRECT;
    }
}
