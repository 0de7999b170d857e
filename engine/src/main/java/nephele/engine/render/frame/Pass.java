package nephele.engine.render.frame;

import java.util.Set;

/** One step of a frame. Its constructor makes what it needs; the {@link LoadContext} owns that and closes it. */
public interface Pass {
    /** Targets that must have been written earlier in the frame. */
    default Set<Target> reads() {
        return Set.of();
    }

    /** What later passes may read; most draw into the view's picture. */
    default Set<Target> writes() {
        return Set.of(Target.SURFACE);
    }

    /** Draws one view. Allocates next to nothing: the whole frame may take 2 KiB. */
    void draw(FrameContext frame);
}
