package nephele.editor.brush;

import java.util.Optional;
import java.util.function.Function;

/** The outcome of an edit: what it makes, or why it is refused. */
public sealed interface BrushEdit<T> {
    /** An edit that succeeded. */
    record Done<T>(T value) implements BrushEdit<T> {}

    /** An edit that would make no valid brush. */
    record Refused<T>(BrushText why) implements BrushEdit<T> {}

    /** Returns the outcome of an edit that succeeded. */
    static <T> BrushEdit<T> done(T value) {
        return new Done<>(value);
    }

    /** Returns the outcome of an edit that is refused. */
    static <T> BrushEdit<T> refused(BrushText why) {
        return new Refused<>(why);
    }

    /** Returns what the edit makes; empty if it is refused. */
    default Optional<T> result() {
        return this instanceof Done<T> done ? Optional.of(done.value) : Optional.empty();
    }

    /** Returns why the edit is refused; empty if it succeeded. */
    default Optional<BrushText> refusal() {
        return this instanceof Refused<T> refused ? Optional.of(refused.why) : Optional.empty();
    }

    /** Returns this outcome with another result, or the same refusal. */
    default <R> BrushEdit<R> map(Function<? super T, ? extends R> change) {
        return flatMap(value -> done(change.apply(value)));
    }

    /** Returns the outcome of a further edit of the result, or the same refusal. */
    default <R> BrushEdit<R> flatMap(Function<? super T, BrushEdit<R>> next) {
        if (this instanceof Done<T> done) {
            return next.apply(done.value);
        }
        return refused(refusal().orElseThrow());
    }
}
