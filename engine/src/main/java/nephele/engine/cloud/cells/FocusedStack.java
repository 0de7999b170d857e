package nephele.engine.cloud.cells;

import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/** The boxes of a cloud as they serve places around a focus. The twin of {@code boxOf} in {@code cloud-march.glsl}. */
final class FocusedStack {
    /** Share of a box's reach, as a logarithm, in which the next one takes over. */
    private static final double FADING = 0.25;

    private final CellStack cloud;
    private final double x;
    private final double z;
    private int level;
    private double next;

    /** @param x of the focus; {@code z} likewise; a finite cloud has none */
    FocusedStack(CellStack cloud, double x, double z) {
        this.cloud = cloud;
        this.x = x;
        this.z = z;
    }

    /** Finds the box of a place. */
    void at(double atX, double atZ) {
        double wide = Math.max(1e-6, Math.max(Math.abs(atX - x), Math.abs(atZ - z)) / cloud.reachMetres());
        double widenings = Math.log(wide) / Math.log(CellStack.WIDENING);
        level = Math.min(cloud.levels() - 1, (int) Math.ceil(Math.max(0, widenings) - 1e-6));
        double fade = (widenings - level + FADING) / FADING;
        next = level + 1 < cloud.levels() ? Math.max(0, Math.min(1, fade)) : 0;
    }

    int level() {
        return level;
    }

    /** Returns the share that the next wider box has already. */
    double next() {
        return next;
    }

    /** Returns the part of a ray that the boxes serve. */
    StackSpan span(Ray ray) {
        Aabb box = cloud.narrowest().box();
        if (!cloud.isLayer()) {
            return StackSpan.of(box, cloud.planetRadiusMetres(), ray);
        }
        double reach = cloud.reachMetres() * Math.pow(CellStack.WIDENING, cloud.levels() - 1);
        var served = new Aabb(x - reach, box.minY(), z - reach, x + reach, box.maxY(), z + reach);
        return StackSpan.of(served, cloud.planetRadiusMetres(), ray);
    }
}
