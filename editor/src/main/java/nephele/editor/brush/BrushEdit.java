package nephele.editor.brush;

import java.util.Optional;
import java.util.function.Function;

/**
 * The outcome of an edit: a result, or the reason for its refusal.
 *
 * @param result empty if the edit would make no valid brush
 * @param refusal empty if the edit succeeded
 */
public record BrushEdit<T>(Optional<T> result, Optional<BrushText> refusal) {
    /** Returns the outcome of an edit that succeeded. */
    public static <T> BrushEdit<T> done(T value) {
        return new BrushEdit<>(Optional.of(value), Optional.empty());
    }

    /** Returns the outcome of an edit that is refused. */
    static <T> BrushEdit<T> refused(BrushText why) {
        return new BrushEdit<>(Optional.empty(), Optional.of(why));
    }

    /** Returns this outcome with another result, or the same refusal. */
    public <R> BrushEdit<R> map(Function<? super T, ? extends R> change) {
        return new BrushEdit<>(result.map(change), refusal);
    }

    /** Returns the outcome of a further edit of the result, or the same refusal. */
    public <R> BrushEdit<R> flatMap(Function<? super T, BrushEdit<R>> next) {
        return result.map(next).orElseGet(() -> new BrushEdit<>(Optional.empty(), refusal));
    }
}
