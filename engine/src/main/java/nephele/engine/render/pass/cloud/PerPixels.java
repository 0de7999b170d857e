package nephele.engine.render.pass.cloud;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Function;

/**
 * The programs of a technique, one for each kind of pixels, compiled when it is first drawn.
 *
 * @param <P> the kind of program
 */
public final class PerPixels<P> {
    private final Function<CloudPixels, P> compile;
    private final Map<CloudPixels, P> programs = new EnumMap<>(CloudPixels.class);

    public PerPixels(Function<CloudPixels, P> compile) {
        this.compile = compile;
    }

    public P of(CloudPixels pixels) {
        return programs.computeIfAbsent(pixels, compile);
    }
}
