package nephele.engine.cloud.cells;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * Optical depths of a whole layer along upright lines and along those of one light, by where a line meets the layer's base:
 * what lies above or below the layer looks them up and need not walk through it. Immutable.
 */
final class LayerCrossing {
    /** Sine of the light's elevation from which on lines are looked up: flatter ones cross too many boxes. */
    static final double LEAST_SINE = 0.05;

    /** Distance after which a walk leaves a box, in its cells, as {@link StackDepths#level} takes widths. */
    private static final double NARROW_CELLS = 0.9 * LayerGrid.WALK;

    private final StackDepths depths;
    private final List<DensityCells> density;
    private final double slantX;
    private final double slantZ;
    /** Metres along the level for each metre of height. */
    private final double slant;
    /** Optical depths along upright lines, an array for each level of boxes, x fastest. */
    private final float[][] upright;

    private final float[][] slanted;
    private final double farthestMetres;

    /** Computes the depths on all processors. @param light unit, towards the light or away from it, not flat */
    LayerCrossing(List<DensityCells> density, StackDepths depths, Vec3 light) {
        this.density = density;
        this.depths = depths;
        Vec3 up = light.y() < 0 ? light.negated() : light;
        slantX = up.x() / up.y();
        slantZ = up.z() / up.y();
        slant = Math.hypot(slantX, slantZ);
        upright = new float[density.size()][];
        slanted = new float[density.size()][];
        for (int level = 0; level < density.size(); level++) {
            upright[level] = columns(level, new Vec3(0, 1, 0));
            slanted[level] = columns(level, up);
        }
        farthestMetres =
                LayerGrid.WALK * density.get(density.size() - 1).cells().sizeX();
    }

    private float[] columns(int level, Vec3 direction) {
        CellBox cells = density.get(level).cells();
        Aabb box = cells.box();
        float[] columns = new float[cells.nx() * cells.nz()];
        IntStream.range(0, cells.nz()).parallel().forEach(k -> {
            for (int i = 0; i < cells.nx(); i++) {
                columns[k * cells.nx() + i] = (float) depths.from(
                        level,
                        cells.centreX(i),
                        box.minY(),
                        cells.centreZ(k),
                        direction.x(),
                        direction.y(),
                        direction.z());
            }
        });
        return columns;
    }

    /** Returns the depth along the upright line through a point. @param cellMetres width of cells that are fine enough */
    double upright(double x, double z, double cellMetres) {
        int level = depths.level(x, z, cellMetres);
        return at(upright[level], density.get(level).cells(), x, z);
    }

    /** Returns the depth along the light's line through a point. */
    double slanted(double x, double y, double z, double cellMetres) {
        double rise = density.get(0).cells().box().minY() - y;
        double across = Math.abs(rise) * slant;
        if (across > farthestMetres) {
            return 0;
        }
        double baseX = x + rise * slantX;
        double baseZ = z + rise * slantZ;
        // As a walk has it, which is in wider boxes after some distance.
        int level = depths.level(baseX, baseZ, Math.max(cellMetres, across / NARROW_CELLS));
        return at(slanted[level], density.get(level).cells(), baseX, baseZ);
    }

    private static double at(float[] columns, CellBox cells, double x, double z) {
        double u = clamped((x - cells.box().minX()) / cells.sizeX() - 0.5, cells.nx() - 1);
        double w = clamped((z - cells.box().minZ()) / cells.sizeZ() - 0.5, cells.nz() - 1);
        int i = (int) u;
        int k = (int) w;
        int at = k * cells.nx() + i;
        int right = i + 1 < cells.nx() ? 1 : 0;
        int next = k + 1 < cells.nz() ? cells.nx() : 0;
        double near = columns[at] + (u - i) * (columns[at + right] - columns[at]);
        double far = columns[at + next] + (u - i) * (columns[at + next + right] - columns[at + next]);
        return near + (w - k) * (far - near);
    }

    private static double clamped(double cells, int last) {
        return cells < 0 ? 0 : cells > last ? last : cells;
    }
}
