package nephele.engine.render.frame;

import java.util.Set;

/** One step of a frame; owns its OpenGL objects. */
public interface Pass extends AutoCloseable {
    Stage stage();

    /** Targets that must have been written earlier in the frame. */
    default Set<Target> reads() {
        return Set.of();
    }

    /** What later passes may read; most draw into the view's picture. */
    default Set<Target> writes() {
        return Set.of(Target.SURFACE);
    }

    /** Whether it draws what is seen where nothing else is. */
    default boolean isSky() {
        return false;
    }

    /** Whether it only guides the player: it can be left out of a picture that is compared with something. */
    default boolean isDecoration() {
        return false;
    }

    /** Called once, before the first draw. */
    void load(LoadContext context);

    /** Draws one view. Allocates next to nothing: the whole frame may take 2 KiB. */
    void draw(FrameContext frame);

    @Override
    void close();
}
