package nephele.engine.render.frame;

import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.Scene;
import nephele.engine.scene.thing.FigurePresence;

/** What a pass is loaded with, once per level. */
public record LoadContext(
        GlContext gl, Scene scene, Output output, Quality quality, FigurePresence figure, SharedResources shared) {}
