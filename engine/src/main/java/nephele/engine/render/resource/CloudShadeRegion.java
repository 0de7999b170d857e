package nephele.engine.render.resource;

import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;

/** The region in which surfaces can be in the shade of clouds; beyond it, its border's shade holds. */
public final class CloudShadeRegion {
    /** Bodies can leave the static shapes by this distance and still find the shade of their place. */
    private static final double MARGIN_METRES = 10;

    private CloudShadeRegion() {}

    public static Aabb of(StaticShapes statics) {
        Aabb bounds = statics.bounds();
        return (bounds.isEmpty() ? new Aabb(0, 0, 0, 0, 0, 0) : bounds).grown(MARGIN_METRES);
    }
}
