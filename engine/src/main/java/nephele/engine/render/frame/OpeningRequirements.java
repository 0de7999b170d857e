package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.MirrorFaces;

/** Why a level needs what draws openings: portals, the gun that makes some, or mirrors. */
public final class OpeningRequirements {
    private OpeningRequirements() {}

    /** @param what of openings the pass draws */
    public static List<Required> of(FrameRequest request, String what, Function<LoadContext, Pass> pass) {
        List<Required> ofPortals = PortalRequirements.of(request, what, pass);
        int mirror = MirrorFaces.firstMaterial(request.level());
        return !ofPortals.isEmpty() || mirror < 0
                ? ofPortals
                : List.of(new Required("materials[" + mirror + "].mirror: " + what, pass));
    }
}
