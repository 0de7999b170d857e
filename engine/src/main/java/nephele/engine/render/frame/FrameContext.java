package nephele.engine.render.frame;

import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Moment;
import nephele.engine.scene.View;
import nephele.engine.scene.VisibleSet;

/**
 * What a pass draws one view with.
 *
 * @param moment what can change, as it is now
 * @param surface what surfaces draw into, see {@link Target#SURFACE}; the same object as {@code picture} unless the
 *     output is HDR or surfaces have several samples a pixel, where it has no texture until these are averaged
 * @param visible solids that the view may see; {@code null} in a scene without solids
 */
public record FrameContext(View view, Moment moment, RenderTarget surface, RenderTarget picture, VisibleSet visible) {}
