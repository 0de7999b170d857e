package nephele.engine.cloud.cells;

import nephele.engine.math.Ray;

/** Optical depths of rays through cells, a sample a cell. For one thread. */
final class CellSums {
    private final DensityCells density;
    private final CellPlace place;

    CellSums(DensityCells density) {
        this.density = density;
        place = new CellPlace(density.cells());
    }

    /** Returns the optical depth of a ray of unit direction up to a length within the box. */
    double along(Ray ray, double length) {
        int steps = (int) Math.ceil(length / density.cells().shortest());
        double step = length / Math.max(1, steps);
        double sum = 0;
        for (int n = 0; n < steps; n++) {
            double at = (n + 0.5) * step;
            place.at(
                    ray.originX() + at * ray.directionX(),
                    ray.originY() + at * ray.directionY(),
                    ray.originZ() + at * ray.directionZ());
            sum += place.of(density.densities(), 1, 0);
        }
        return sum * step * density.greatestPerMetre();
    }
}
