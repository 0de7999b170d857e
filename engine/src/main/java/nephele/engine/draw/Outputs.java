package nephele.engine.draw;

import nephele.engine.level.Level;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.pass.tonemap.ToneMapPass;

/** Which output a level asks for when nobody else says. */
public final class Outputs {
    private Outputs() {}

    /** HDR where something in the level requires tone mapping as a pass, else DIRECT. */
    public static Output requiredBy(Level level) {
        return ToneMapPass.FEATURE
                        .requiredBy()
                        .apply(FrameRequest.of(level, Output.DIRECT))
                        .isEmpty()
                ? Output.DIRECT
                : Output.HDR;
    }
}
