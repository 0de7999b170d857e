package nephele.engine.render.frame;

import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Moment;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.VisibleSet;

/**
 * What a pass draws one view with.
 *
 * @param moment what can change, as it is now
 * @param surface what surfaces draw into, see {@link Target#SURFACE}; the same object as {@code picture} unless the
 *     output is HDR or surfaces have several samples a pixel, where it has no texture until these are averaged
 * @param visible solids that the view may see; {@code null} in a scene without solids
 * @param node where the view stands among the views of the frame; {@code null} in a level where portals cannot be
 * @param nested draws what is seen through portals; {@code null} as {@code node}
 */
public record FrameContext(
        View view,
        Moment moment,
        RenderTarget surface,
        RenderTarget picture,
        VisibleSet visible,
        ViewNode node,
        NestedViews nested) {
    /** The same with another target for surfaces. */
    public FrameContext withSurface(RenderTarget newSurface) {
        return new FrameContext(view, moment, newSurface, picture, visible, node, nested);
    }

    /** Elements of {@code gl_ClipDistance} that cut surfaces: one in a view through a portal. */
    public int clipDistances() {
        return view.clip() == null ? 0 : 1;
    }
}
