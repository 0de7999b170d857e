package nephele.engine.render.pass.cloud;

import nephele.engine.render.frame.LoadContext;

/**
 * What a technique is built with.
 *
 * @param impostors of clouds of balls; {@code null} if there are to be none
 */
public record CloudContext(LoadContext load, Impostors impostors) {
    public CloudContext withoutImpostors() {
        return new CloudContext(load, null);
    }
}
