package nephele.engine.render.frame;

import nephele.engine.math.Vec3;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.ViewNode;

/** Draws the views through openings, for the passes that fill them. */
public interface NestedViews {
    /** The content of an opening. */
    enum Filling {
        /** The sky of the view behind it, {@link #drawSky drawn} in place, and a membrane in front. */
        SKY,
        /** The view behind it, {@link #draw drawn} in place. */
        VIEW,
        /** A {@link #picture}. */
        PICTURE,
        /** The colour {@link #MARK}. */
        MARK
    }

    /** The colour of an opening that is not drawn, in pictures whose colours identify surfaces. */
    Vec3 MARK = new Vec3(1, 0, 1);

    Filling filling(ViewNode child);

    /** Draws a view that is visible in {@code frame} into the same target, limited by the stencil. */
    void draw(FrameContext frame, ViewNode child);

    /** Draws the background of a view that is visible in {@code frame}, limited by the stencil. */
    void drawSky(FrameContext frame, ViewNode child);

    /** Returns the stencil value with which the drawing of a view begins: the number of openings before it. */
    int openingsCounted(ViewNode node);

    /**
     * Returns the picture that covers an opening, at the coordinates of {@link
     * nephele.engine.render.resource.OpeningMesh}.
     */
    Texture picture(ViewNode child);
}
