package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.LoadContext;

/**
 * What a technique is built with.
 *
 * @param impostors of clouds of balls; {@code null} if there are to be none
 * @param ranges number of bounds that programs for {@link CloudPixels#MIXED} know
 */
public record CloudContext(LoadContext load, Impostors impostors, int ranges) {
    public CloudContext withoutImpostors() {
        return new CloudContext(load, null, ranges);
    }
}
