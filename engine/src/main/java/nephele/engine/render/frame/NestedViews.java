package nephele.engine.render.frame;

import nephele.engine.render.gl.Texture;
import nephele.engine.scene.ViewNode;

/** What is seen through portals, for the passes that fill their openings. */
public interface NestedViews {
    /** What fills an opening. */
    enum Filling {
        /** The sky of the view behind it, {@link #drawSky drawn} in place, and a membrane before that. */
        SKY,
        /** The view behind it, {@link #draw drawn} in place. */
        VIEW,
        /** A {@link #picture}. */
        PICTURE,
        /** The colour {@link #MARK}. */
        MARK
    }

    /** Stands for what is not drawn, where colours tell surfaces apart; 0xRRGGBB. */
    int MARK = 0xff00ff;

    Filling filling(ViewNode child);

    /** Draws a view that is seen in {@code frame} into the same target, as the stencil allows. */
    void draw(FrameContext frame, ViewNode child);

    /** Draws what a view that is seen in {@code frame} has where nothing else is, as the stencil allows. */
    void drawSky(FrameContext frame, ViewNode child);

    /** How many openings the stencil of a target counts where a view begins to be drawn into it. */
    int openingsCounted(ViewNode node);

    /** What covers an opening, at the places that {@link nephele.engine.render.resource.OpeningMesh} tells. */
    Texture picture(ViewNode child);
}
