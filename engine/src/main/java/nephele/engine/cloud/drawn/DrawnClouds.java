package nephele.engine.cloud.drawn;

import java.util.List;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.math.Vec3;

/**
 * All clouds of a level at one time, sampled for drawing. Immutable.
 *
 * @param towardsSun unit
 */
public record DrawnClouds(List<DrawnCloud> all, Vec3 towardsSun) {
    private static final Vec3 NOON = new Vec3(0, 1, 0);
    private static final CellMarch.OutsideOfCloud DARK =
            new CellMarch.OutsideOfCloud(NOON, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    public DrawnClouds {
        all = List.copyOf(all);
    }

    /** Returns the share of the sun's light that reaches a point through all clouds. */
    public double sunShare(Vec3 at) {
        double share = 1;
        for (DrawnCloud cloud : all) {
            var march = cloud.march(DARK);
            march.march(
                    cloud.drifting(at, towardsSun.x(), towardsSun.y(), towardsSun.z()),
                    0,
                    Double.POSITIVE_INFINITY,
                    1,
                    0.5);
            share *= march.transmittance();
        }
        return share;
    }
}
