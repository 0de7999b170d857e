package nephele.engine.cloud.cells;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** Samples clouds into cells. */
public final class StackBuilder {
    /** Cells of density along each edge of a cell of light. */
    private static final int LIGHT_DIVISOR = 2;

    private StackBuilder() {}

    /** Returns the boxes of a layer around a point, from the narrowest on. */
    public static List<CellBox> around(double x, double z, CellBox narrowest, int levels) {
        Aabb box = narrowest.box();
        double half = (box.maxX() - box.minX()) / 2;
        List<CellBox> boxes = new ArrayList<>();
        for (int level = 0; level < levels; level++) {
            boxes.add(new CellBox(
                    new Aabb(x - half, box.minY(), z - half, x + half, box.maxY(), z + half),
                    narrowest.nx(),
                    narrowest.ny(),
                    narrowest.nz()));
            half *= CellStack.WIDENING;
        }
        return boxes;
    }

    /**
     * The light around a cloud.
     *
     * @param towardsSun unit
     * @param beyond what lies outside the cloud
     */
    public record Light(Vec3 towardsSun, DepthBeyond beyond) {}

    /** Computes the light in cells; the depth beyond a box is that of the next wider one. */
    public static List<LightCells> lit(List<DensityCells> density, CloudLight physics, Light light) {
        List<LightCells> lit = new ArrayList<>();
        for (int level = 0; level < density.size(); level++) {
            DepthBeyond beyond =
                    level + 1 < density.size() ? beyond(density, level + 1, light.beyond()) : light.beyond();
            lit.add(LightCells.of(density.get(level), LIGHT_DIVISOR, physics, light.towardsSun(), beyond));
        }
        return lit;
    }

    private static DepthBeyond beyond(List<DensityCells> density, int level, DepthBeyond outside) {
        DepthBeyond farther = level + 1 < density.size() ? beyond(density, level + 1, outside) : outside;
        DensityCells wider = density.get(level);
        return (x, y, z, dx, dy, dz) -> {
            double length = exit(wider.cells().box(), x, y, z, dx, dy, dz);
            double own = new CellSums(wider).along(new Ray(x, y, z, dx, dy, dz), length);
            return own + farther.depth(x + length * dx, y + length * dy, z + length * dz, dx, dy, dz);
        };
    }

    private static double exit(Aabb box, double x, double y, double z, double dx, double dy, double dz) {
        double alongX = exit(x, dx, box.minX(), box.maxX());
        double alongY = exit(y, dy, box.minY(), box.maxY());
        return Math.min(alongX, Math.min(alongY, exit(z, dz, box.minZ(), box.maxZ())));
    }

    private static double exit(double from, double direction, double min, double max) {
        return direction == 0
                ? Double.POSITIVE_INFINITY
                : Math.max(0, ((direction > 0 ? max : min) - from) / direction);
    }
}
