package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.Level;

/**
 * Something that can be drawn, and what in a level asks for it.
 *
 * @param name as printed by {@code explain}
 * @param requiredBy empty when nothing in the level asks for it; one pass is built for each element
 */
public record RenderFeature(String name, Function<Level, List<Required>> requiredBy) {}
