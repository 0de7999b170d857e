package nephele.engine.render.frame;

import java.util.function.Function;

/**
 * A reason for a pass.
 *
 * @param because JSON path in the level, a colon and the reason: {@code environment.sky: a gradient}
 */
public record Required(String because, Function<LoadContext, Pass> build) {}
