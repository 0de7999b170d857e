package nephele.engine.render;

import java.util.List;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.Pass;

/**
 * The passes of every view, in order.
 *
 * @param skies those passes that draw the background
 * @param opaque the number of passes before {@link nephele.engine.render.frame.Stage#IN_VIEWS_AFTER_OPAQUE}
 */
record ViewPasses(List<Pass> passes, List<Pass> skies, int opaque) {
    /** Draws a view, with copies of it for the passes that read them. */
    void draw(FrameContext frame, ViewCopies copies) {
        for (int i = 0; i < passes.size(); i++) {
            draw(i, frame, copies);
        }
    }

    /** Draws one step of a view. */
    void draw(int index, FrameContext frame, ViewCopies copies) {
        if (index == opaque) {
            copies.take(frame.surface());
        }
        passes.get(index).draw(frame);
    }
}
