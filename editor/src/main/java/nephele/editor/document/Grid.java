package nephele.editor.document;

import nephele.engine.math.Vec3;

/** The grid that places and sizes snap to. A power of two keeps all its multiples exact. */
public record Grid(double stepMetres) {
    public static final double FINEST_METRES = 1.0 / 8;
    public static final double COARSEST_METRES = 32;

    public Grid {
        stepMetres = Math.max(FINEST_METRES, Math.min(COARSEST_METRES, stepMetres));
    }

    public Grid finer() {
        return new Grid(stepMetres / 2);
    }

    public Grid coarser() {
        return new Grid(stepMetres * 2);
    }

    /** Returns the nearest multiple of the step. */
    public double snapped(double value) {
        return stepMetres * Math.rint(value / stepMetres) + 0.0;
    }

    public Vec3 snapped(Vec3 point) {
        return new Vec3(snapped(point.x()), snapped(point.y()), snapped(point.z()));
    }
}
