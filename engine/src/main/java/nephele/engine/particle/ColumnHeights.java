package nephele.engine.particle;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Emitter;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * The first surface below the top of an emitter's box, by column: what falls ends there. A grid over the box and the
 * metre around it, found once with a ray down the middle of each cell.
 */
final class ColumnHeights {
    private static final double LEAST_CELL_METRES = 0.125;
    private static final int MOST_CELLS = 192;
    private static final double AROUND_METRES = 1;

    private final double minX;
    private final double minZ;
    private final double cells;
    private final int columns;
    private final int rows;
    /** Relative to the emitter's centre; −infinity where nothing is below. */
    private final float[] heights;

    private ColumnHeights(double minX, double minZ, double cell, int columns, int rows) {
        this.minX = minX;
        this.minZ = minZ;
        cells = 1 / cell;
        this.columns = columns;
        this.rows = rows;
        heights = new float[columns * rows];
    }

    static ColumnHeights of(Emitter emitter, CollisionWorld world) {
        double x = emitter.size().x() + 2 * AROUND_METRES;
        double z = emitter.size().z() + 2 * AROUND_METRES;
        double cell = Math.max(LEAST_CELL_METRES, Math.max(x, z) / MOST_CELLS);
        ColumnHeights grid =
                new ColumnHeights(-x / 2, -z / 2, cell, (int) Math.ceil(x / cell), (int) Math.ceil(z / cell));
        double top = emitter.size().y() / 2;
        Aabb extent = world.extent();
        double farthest = extent.isEmpty() ? 0 : emitter.centre().y() + top - extent.minY() + 1;
        RayCast cast = new RayCast();
        Ray ray = Ray.reusable();
        for (int i = 0; i < grid.heights.length; i++) {
            double atX = emitter.centre().x() + grid.minX + (i % grid.columns + 0.5) * cell;
            double atZ = emitter.centre().z() + grid.minZ + (i / grid.columns + 0.5) * cell;
            ray.aim(atX, emitter.centre().y() + top, atZ, 0, -1, 0);
            boolean hits = farthest > 0 && cast.cast(world, ray, farthest);
            grid.heights[i] = hits ? (float) (top - cast.distance()) : Float.NEGATIVE_INFINITY;
        }
        return grid;
    }

    /** Returns the height at a place; all relative to the emitter's centre. */
    double at(double x, double z) {
        int column = Math.min(columns - 1, Math.max(0, (int) ((x - minX) * cells)));
        int row = Math.min(rows - 1, Math.max(0, (int) ((z - minZ) * cells)));
        return heights[row * columns + column];
    }
}
