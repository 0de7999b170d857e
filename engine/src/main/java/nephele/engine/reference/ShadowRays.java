package nephele.engine.reference;

import java.util.Arrays;
import nephele.engine.math.Ray;
import org.joml.Vector3dc;

/**
 * Asks whether light arrives. What shaded the last place from a light likely shades the next one, so that is tried
 * first; the answer does not depend on it. One for each thread.
 */
final class ShadowRays {
    private final SurfaceRays surfaces;
    private final int[] lastBlockers;

    /** @param lights numbers of lights are less than this */
    ShadowRays(SurfaceRays surfaces, int lights) {
        this.surfaces = surfaces;
        lastBlockers = new int[lights];
        Arrays.fill(lastBlockers, -1);
    }

    /**
     * @param light tells apart whose light it is
     * @param limit parameter of the ray up to which something is in the way
     * @param except the item that is lit: a convex thing does not shade itself
     */
    boolean isBlocked(int light, Vector3dc origin, Vector3dc direction, double limit, int except) {
        Ray ray = SurfaceRays.ray(origin, direction);
        int last = lastBlockers[light];
        if (last >= 0 && last != except && surfaces.isBlockedBy(last, ray, limit)) {
            return true;
        }
        int blocker = surfaces.blocker(ray, limit, except);
        lastBlockers[light] = blocker >= 0 ? blocker : last;
        return blocker >= 0;
    }
}
