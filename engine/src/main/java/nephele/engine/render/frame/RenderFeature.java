package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;

/**
 * Something that can be drawn, and what asks for it.
 *
 * @param name as printed by {@code explain}
 * @param requiredBy empty when nothing in the request asks for it; one pass is built for each element
 */
public record RenderFeature(String name, Function<FrameRequest, List<Required>> requiredBy) {}
