package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.Level;

/** Decides why a level needs the passes for portals, as opposed to mirrors. */
public final class PortalRequirements {
    private PortalRequirements() {}

    /** @param what the part of portals that the pass draws */
    public static List<Required> of(FrameRequest request, String what, Function<LoadContext, Pass> pass) {
        Level level = request.level();
        if (!level.portals().isEmpty()) {
            return List.of(new Required("portals: " + what, pass));
        }
        return level.portalGun() == null ? List.of() : List.of(new Required("portalGun: " + what, pass));
    }
}
