package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.LoadContext;

/**
 * What a technique is built with.
 *
 * @param ranges number of bounds that programs for {@link CloudPixels#MIXED} know
 */
public record CloudContext(LoadContext load, int ranges) {}
