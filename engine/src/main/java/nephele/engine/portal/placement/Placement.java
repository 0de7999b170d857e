package nephele.engine.portal.placement;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;

/**
 * Where a shot's portal goes. One gun among fixed surfaces, asked again and again; the answer depends on the question
 * only. One for each thread.
 */
public final class Placement {
    private final Gun gun;

    public Placement(Surfaces surfaces, Gun gun) {
        this.gun = gun;
    }

    /**
     * @param id of the portal to be
     * @param others that stay open beside it
     * @param moving what else stops the shot
     */
    public Placed place(String id, Aim aim, List<Portal> others, MovingSurfaces moving) {
        Vec3 direction = aim.direction();
        var end = aim.eye().toVector().fma(gun.rangeMetres(), direction.toVector());
        return new Placed.Refused(Refusal.NOTHING_HIT, new Vec3(end.x, end.y, end.z));
    }
}
