package nephele.engine.render.frame;

import java.util.function.Supplier;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.scene.Scene;

/** The arguments for building a pass, once per renderer. */
public record LoadContext(GlContext gl, Scene scene, FrameRequest request, SharedResources shared) {
    public Output output() {
        return request.output();
    }

    public Quality quality() {
        return request.quality();
    }

    /** Owns an object as {@link SharedResources#own} does: a pass closes nothing itself. */
    public <T extends GlObject> T own(T object) {
        return shared.own(object);
    }

    /** Shares an object as {@link SharedResources#share} does. */
    public <T extends GlObject> T share(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return shared.share(kind, madeFrom, make);
    }
}
