package nephele.engine.render.frame;

import nephele.engine.math.Frustum;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;
import nephele.engine.scene.VisibleSet;
import org.joml.Matrix4d;

/** The arguments of a pass for one view; one object serves all frames, and no pass keeps it. */
public final class FrameContext {
    private final NestedViews nested;
    private View view;
    private FrameState frameState;
    private RenderTarget surface;
    private RenderTarget picture;
    private VisibleSet visible;
    private ViewNode node;
    private Frustum limits;
    private final Frustum whole = Frustum.reusable(6);
    private final Matrix4d clipFromRelative = new Matrix4d();

    /** @param nested draws the views through openings; {@code null} in a level that cannot have openings */
    public FrameContext(NestedViews nested) {
        this.nested = nested;
    }

    /** Begins the views of a frame. */
    public void begin(FrameState newFrameState, RenderTarget newSurface) {
        frameState = newFrameState;
        surface = newSurface;
        picture = null;
    }

    /** Begins a pass after all views, which reads one picture and writes another one. */
    public void setPictures(RenderTarget read, RenderTarget written) {
        surface = read;
        picture = written;
    }

    /**
     * Sets the view.
     *
     * @param newLimits frustum for culling dynamic objects; {@code null} for that of the view's picture
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

    /** Returns the dynamic state of the frame. */
    public FrameState frameState() {
        return frameState;
    }

    /**
     * Returns the target of surfaces, see {@link Target#SURFACE}; it may have no texture. After all views: the picture
     * that the pass reads.
     */
    public RenderTarget surface() {
        return surface;
    }

    /** Returns the picture that a pass after all views writes; {@code null} before. */
    public RenderTarget picture() {
        return picture;
    }

    /** Returns the solids that the view may see; {@code null} in a scene without solids, or if only the sky is drawn. */
    public VisibleSet visible() {
        return visible;
    }

    /** Returns the frustum for culling dynamic objects; {@code null} for that of the view's picture. */
    public Frustum limits() {
        return limits;
    }

    /** Returns the frustum outside of which nothing is visible: {@link #limits}, or that of the view's picture. */
    public Frustum frustum() {
        if (limits != null) {
            return limits;
        }
        whole.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        whole.keepAll(view.clipFromRelative(clipFromRelative));
        return whole;
    }

    /** Returns the node of the view in the frame's view tree; {@code null} in a level that cannot have openings. */
    public ViewNode node() {
        return node;
    }

    /** Returns the object that draws the views through openings; {@code null} if {@link #node} is. */
    public NestedViews nested() {
        return nested;
    }

    /**
     * Returns the number of elements of {@code gl_ClipDistance} that clip surfaces: one in a view through an opening.
     */
    public int clipDistances() {
        return view.clip() == null ? 0 : 1;
    }
}
