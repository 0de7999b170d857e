package nephele.engine.cloud.field;

import java.util.OptionalDouble;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * A homogeneous medium in a box.
 *
 * @param bounds may be infinite
 * @param extinctionPerMetre at least 0
 */
public record UniformField(Aabb bounds, double extinctionPerMetre) implements ExtinctionField {
    @Override
    public double perMetre(double x, double y, double z) {
        return bounds.contains(x, y, z) ? extinctionPerMetre : 0;
    }

    @Override
    public boolean isEmpty() {
        return extinctionPerMetre == 0 || bounds.isEmpty();
    }

    @Override
    public MajorantWalk walk(Ray ray, double fromMetres, double toMetres) {
        return new UniformWalk(RaySpan.inBox(ray, bounds, fromMetres, toMetres), extinctionPerMetre);
    }

    @Override
    public OptionalDouble closedDepth(Ray ray, double fromMetres, double toMetres) {
        RaySpan span = RaySpan.inBox(ray, bounds, fromMetres, toMetres);
        boolean empty = span.isEmpty() || extinctionPerMetre == 0;
        return OptionalDouble.of(empty ? 0 : extinctionPerMetre * (span.toMetres() - span.fromMetres()));
    }
}
