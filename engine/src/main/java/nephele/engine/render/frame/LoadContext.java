package nephele.engine.render.frame;

import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.Scene;

/** What a pass is loaded with, once per level. */
public record LoadContext(GlContext gl, Scene scene, FrameRequest request, SharedResources shared) {
    public Output output() {
        return request.output();
    }

    public Quality quality() {
        return request.quality();
    }
}
