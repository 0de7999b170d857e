package nephele.engine.cloud.drawn;

import java.util.List;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A cloud of a level at one time, sampled for drawing.
 *
 * @param cells in the space that drifts with the cloud
 * @param plans of its boxes; empty unless of noise with a profile
 * @param sheet columns of its boxes; empty unless it is drawn as a sheet of them
 * @param drift how far the wind has carried it
 * @param fullPerMetre extinction that density 1 stands for when its weather has come wholly
 */
public record DrawnCloud(
        CloudSource source,
        CellStack cells,
        List<PlanCells> plans,
        List<SheetColumns> sheet,
        Vec3 drift,
        double fullPerMetre) {
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
