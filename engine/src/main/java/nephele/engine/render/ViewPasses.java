package nephele.engine.render;

import java.util.List;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.gl.CopiedPlanes;

/**
 * The passes of every view, in order.
 *
 * @param skies those passes that draw the background
 * @param opaque the number of passes before {@link nephele.engine.render.frame.Stage#IN_VIEWS_AFTER_OPAQUE}
 * @param depthReaders those passes that read a copy of their view's depth
 * @param colourReaders those passes that read a copy of its colours
 */
record ViewPasses(List<Pass> passes, List<Pass> skies, int opaque, List<Pass> depthReaders, List<Pass> colourReaders) {
    /** Draws a view, with copies of it for the passes that read them. */
    void draw(FrameContext frame, ViewCopies copies) {
        for (int i = 0; i < passes.size(); i++) {
            draw(i, frame, copies);
        }
    }

    /** Draws one step of a view. */
    void draw(int index, FrameContext frame, ViewCopies copies) {
        if (index == opaque) {
            CopiedPlanes needed = needed(frame);
            if (needed != null) {
                copies.take(frame.surface(), needed);
            }
        }
        passes.get(index).draw(frame);
    }

    /** Returns what passes read in this view; {@code null} for nothing. */
    private CopiedPlanes needed(FrameContext frame) {
        boolean isDepth = isNeeded(depthReaders, frame);
        if (isNeeded(colourReaders, frame)) {
            return isDepth ? CopiedPlanes.COLOUR_AND_DEPTH : CopiedPlanes.COLOUR;
        }
        return isDepth ? CopiedPlanes.DEPTH : null;
    }

    private static boolean isNeeded(List<Pass> readers, FrameContext frame) {
        for (int i = 0; i < readers.size(); i++) {
            if (readers.get(i).needsCopies(frame)) {
                return true;
            }
        }
        return false;
    }
}
