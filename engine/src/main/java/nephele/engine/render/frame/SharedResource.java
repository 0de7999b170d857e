package nephele.engine.render.frame;

import java.util.function.BiConsumer;
import java.util.function.Function;
import nephele.engine.scene.View;

/**
 * An object that several passes of a renderer read, made when the first of them asks for it. It is a constant of the
 * object's class; a {@link RenderFeature} names the constants that its pass uses.
 *
 * @param make makes the object, which the context's owner closes; returns {@code null} if the level has none
 * @param follow updates it at the begin of a frame; {@code null} for what does not change
 * @param setView prepares it for the draws of a view; {@code null} for what is the same in all views
 */
public record SharedResource<T>(
        String name, Function<LoadContext, T> make, BiConsumer<T, FrameContext> follow, BiConsumer<T, View> setView) {

    /** Returns an object that stays the same in all frames. */
    public static <T> SharedResource<T> of(String name, Function<LoadContext, T> make) {
        return new SharedResource<>(name, make, null, null);
    }

    /** Returns this object with an update at the begin of each frame, after those of what it was made from. */
    public SharedResource<T> following(BiConsumer<T, FrameContext> newFollow) {
        return new SharedResource<>(name, make, newFollow, setView);
    }

    /** Returns this object with an update before the draws of each view. */
    public SharedResource<T> inViews(BiConsumer<T, View> newSetView) {
        return new SharedResource<>(name, make, follow, newSetView);
    }
}
