package nephele.engine.render.frame;

import java.util.function.Function;
import nephele.engine.render.gl.GlContext;

/**
 * A reason for a pass to exist.
 *
 * @param because JSON path in the level, a colon and the reason: {@code environment.sky: a gradient}
 */
public record Required(String because, Function<GlContext, Pass> build) {}
