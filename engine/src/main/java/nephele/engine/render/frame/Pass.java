package nephele.engine.render.frame;

import java.util.Set;

/** One step of a frame. Its constructor creates its resources; the {@link LoadContext} owns and closes them. */
public interface Pass {
    /** Returns the targets that must have been written earlier in the frame. */
    default Set<Target> reads() {
        return Set.of();
    }

    /** Returns the targets that later passes may read; most passes draw into the view's picture. */
    default Set<Target> writes() {
        return Set.of(Target.SURFACE);
    }

    /**
     * Returns false if {@link #draw} does not need the copies of this view that {@link #reads} names. A view is copied
     * only for passes that do.
     */
    default boolean needsCopies(FrameContext frame) {
        return true;
    }

    /** Draws one view. Allocates almost nothing: the whole frame may allocate 2 KiB. */
    void draw(FrameContext frame);
}
