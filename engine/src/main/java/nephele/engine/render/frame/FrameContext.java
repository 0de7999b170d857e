package nephele.engine.render.frame;

import nephele.engine.math.Frustum;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.VisibleSet;

/** What a pass draws one view with; one object serves frame after frame, and no pass keeps it. */
public final class FrameContext {
    private final NestedViews nested;
    private View view;
    private FrameState frameState;
    private RenderTarget surface;
    private RenderTarget picture;
    private VisibleSet visible;
    private ViewNode node;
    private Frustum limits;

    /** @param nested draws what is seen through portals; {@code null} in a level where portals cannot be */
    public FrameContext(NestedViews nested) {
        this.nested = nested;
    }

    /** Begins a frame. */
    public void setTarget(FrameState newFrameState, RenderTarget newSurface, RenderTarget newPicture) {
        frameState = newFrameState;
        surface = newSurface;
        picture = newPicture;
    }

    /** Another target for surfaces, as when their samples have been averaged. */
    public void setTarget(RenderTarget newSurface) {
        surface = newSurface;
    }

    /**
     * Looks from somewhere.
     *
     * @param newLimits beyond which nothing that moves is drawn; {@code null} for the sides of the view's picture
     */
    public void setView(View newView, ViewNode newNode, VisibleSet newVisible, Frustum newLimits) {
        limits = newLimits;
        view = newView;
        node = newNode;
        visible = newVisible;
    }

    public View view() {
        return view;
    }

    /** What can change, as it is now. */
    public FrameState frameState() {
        return frameState;
    }

    /**
     * What surfaces draw into, see {@link Target#SURFACE}; the same object as {@link #picture} unless the output is HDR
     * or surfaces have several samples a pixel, where it has no texture until these are averaged.
     */
    public RenderTarget surface() {
        return surface;
    }

    public RenderTarget picture() {
        return picture;
    }

    /** Solids that the view may see; {@code null} in a scene without solids. */
    public VisibleSet visible() {
        return visible;
    }

    /** What of things that move the view may see; {@code null} for all in the view's picture. */
    public Frustum limits() {
        return limits;
    }

    /** Where the view stands among the views of the frame; {@code null} in a level where portals cannot be. */
    public ViewNode node() {
        return node;
    }

    /** Draws what is seen through portals; {@code null} as {@link #node}. */
    public NestedViews nested() {
        return nested;
    }

    /** Elements of {@code gl_ClipDistance} that cut surfaces: one in a view through a portal. */
    public int clipDistances() {
        return view.clip() == null ? 0 : 1;
    }
}
