package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.Level;

/** Why a level needs what draws portals, as opposed to mirrors. */
public final class PortalRequirements {
    private PortalRequirements() {}

    /** @param what of portals the pass draws */
    public static List<Required> of(FrameRequest request, String what, Function<LoadContext, Pass> pass) {
        Level level = request.level();
        if (!level.portals().isEmpty()) {
            return List.of(new Required("portals: " + what, pass));
        }
        return level.portalGun() == null ? List.of() : List.of(new Required("portalGun: " + what, pass));
    }
}
