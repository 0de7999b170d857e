package nephele.engine.scene.light;

import java.util.List;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Which boxes lie wholly in a lamp's shadow. What a convex solid hides from a point is convex: a box whose eight corners
 * are hidden by the same solid is hidden whole. Never wrongly yes.
 */
public final class LampOcclusion {
    private final Occluders solids;
    private final List<Lamp> lamps;
    private final int[] firstLayer;

    /** @param firstLayer negative for lamps whose light passes through everything */
    LampOcclusion(StaticShapes statics, List<Lamp> lamps, int[] firstLayer) {
        this.solids = new Occluders(statics);
        this.lamps = lamps;
        this.firstLayer = firstLayer;
    }

    boolean hides(int lamp, Aabb box) {
        if (firstLayer[lamp] < 0) {
            return false;
        }
        Vec3 p = lamps.get(lamp).position();
        double[][] towards = new double[8][3];
        for (int corner = 0; corner < 8; corner++) {
            towards[corner][0] = ((corner & 1) == 0 ? box.minX() : box.maxX()) - p.x();
            towards[corner][1] = ((corner & 2) == 0 ? box.minY() : box.maxY()) - p.y();
            towards[corner][2] = ((corner & 4) == 0 ? box.minZ() : box.maxZ()) - p.z();
        }
        return solids.oneMeetsAllSegments(new double[] {p.x(), p.y(), p.z()}, towards);
    }
}
