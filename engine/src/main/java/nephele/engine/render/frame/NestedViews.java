package nephele.engine.render.frame;

import nephele.engine.scene.ViewNode;

/** What is seen through portals, for the passes that fill their openings. */
public interface NestedViews {
    /** Whether there is anything to fill an opening with; where not, the wall that it lies in shows. */
    boolean fills(ViewNode child);

    /** Draws a view that is seen in {@code frame} into the same target, as the stencil allows. */
    void draw(FrameContext frame, ViewNode child);
}
