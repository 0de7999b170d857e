package nephele.engine.cloud.drawn;

import java.util.List;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A cloud of a level at one time, sampled for drawing.
 *
 * @param boxes of its cells, the narrowest first
 * @param cells of all boxes, lit, in the space that drifts with the cloud
 * @param drift how far the wind has carried it
 */
public record DrawnCloud(CloudSource source, List<CloudSource.Box> boxes, CellStack cells, Vec3 drift) {
    /** Returns a march through it. */
    CellMarch march(CellMarch.OutsideOfCloud outside) {
        return new CellMarch(cells, outside);
    }

    /** Returns a ray of the world in the space of the cells. */
    Ray drifting(Vec3 from, double dx, double dy, double dz) {
        Vec3 origin = from.minus(drift);
        return new Ray(origin.x(), origin.y(), origin.z(), dx, dy, dz);
    }
}
