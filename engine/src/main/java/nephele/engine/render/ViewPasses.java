package nephele.engine.render;

import java.util.List;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.Pass;

/**
 * The passes of every view, in order.
 *
 * @param skies those passes that draw the background
 * @param opaque the number of passes before {@link nephele.engine.render.frame.Stage#IN_VIEWS_AFTER_OPAQUE}
 * @param readers those passes that read copies of their view
 */
record ViewPasses(List<Pass> passes, List<Pass> skies, int opaque, List<Pass> readers) {
    /** Draws a view, with copies of it for the passes that read them. */
    void draw(FrameContext frame, ViewCopies copies) {
        for (int i = 0; i < passes.size(); i++) {
            draw(i, frame, copies);
        }
    }

    /** Draws one step of a view. */
    void draw(int index, FrameContext frame, ViewCopies copies) {
        if (index == opaque && isCopyRead(frame)) {
            copies.take(frame.surface());
        }
        passes.get(index).draw(frame);
    }

    private boolean isCopyRead(FrameContext frame) {
        for (int i = 0; i < readers.size(); i++) {
            if (readers.get(i).needsCopies(frame)) {
                return true;
            }
        }
        return false;
    }
}
