package nephele.engine.render.frame;

import java.util.List;
import java.util.function.Function;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.MirrorFaces;

/**
 * A reason for a pass.
 *
 * @param because JSON path in the level, a colon and the reason: {@code environment.sky: a gradient}
 */
public record Required(String because, Function<LoadContext, Pass> build) {
    /** Returns why a level needs a pass for portals, as opposed to mirrors. @param what the part that the pass draws */
    public static List<Required> ofPortals(FrameRequest request, String what, Function<LoadContext, Pass> pass) {
        Level level = request.level();
        if (!level.portals().isEmpty()) {
            return List.of(new Required("portals: " + what, pass));
        }
        return level.portalGun() == null ? List.of() : List.of(new Required("portalGun: " + what, pass));
    }

    /** Returns why a level needs a pass for openings: portals, a portal gun, or mirrors. @param what the part that it draws */
    public static List<Required> ofOpenings(FrameRequest request, String what, Function<LoadContext, Pass> pass) {
        List<Required> ofPortals = ofPortals(request, what, pass);
        int mirror = MirrorFaces.firstMaterial(request.level());
        return !ofPortals.isEmpty() || mirror < 0
                ? ofPortals
                : List.of(new Required("materials[" + mirror + "].mirror: " + what, pass));
    }
}
