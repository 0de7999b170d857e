package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.Level;
import nephele.engine.render.gl.GlContext;

/** Why a level needs what draws portals, as opposed to mirrors. */
public final class PortalNeeds {
    private PortalNeeds() {}

    /** @param what of portals the pass draws */
    public static List<Required> of(Level level, String what, Function<GlContext, Pass> pass) {
        if (!level.portals().isEmpty()) {
            return List.of(new Required("portals: " + what, pass));
        }
        return level.portalGun() == null ? List.of() : List.of(new Required("portalGun: " + what, pass));
    }
}
