package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.appearance.MirrorFaces;

/** Decides why a level needs the passes for openings: portals, a portal gun, or mirrors. */
public final class OpeningRequirements {
    private OpeningRequirements() {}

    /** @param what the part of openings that the pass draws */
    public static List<Required> of(FrameRequest request, String what, Function<LoadContext, Pass> pass) {
        List<Required> ofPortals = PortalRequirements.of(request, what, pass);
        int mirror = MirrorFaces.firstMaterial(request.level());
        return !ofPortals.isEmpty() || mirror < 0
                ? ofPortals
                : List.of(new Required("materials[" + mirror + "].mirror: " + what, pass));
    }
}
