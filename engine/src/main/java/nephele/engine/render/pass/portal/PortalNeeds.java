package nephele.engine.render.pass.portal;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.Level;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.Required;
import nephele.engine.render.gl.GlContext;

/** Why a level needs the passes of this package. */
final class PortalNeeds {
    private PortalNeeds() {}

    static List<Required> of(Level level, Function<GlContext, Pass> pass) {
        if (!level.portals().isEmpty()) {
            return List.of(new Required("portals: openings to see through", pass));
        }
        return level.portalGun() == null
                ? List.of()
                : List.of(new Required("portalGun: opens portals to see through", pass));
    }
}
