package nephele.engine.cloud.field;

import nephele.engine.cloud.MajorantWalk;

/** The walk of a field whose extinction has one upper bound on one span of the ray. */
final class UniformWalk implements MajorantWalk {
    private final RaySpan span;
    private final double perMetre;
    private boolean begun;

    UniformWalk(RaySpan span, double perMetre) {
        this.span = span;
        this.perMetre = perMetre;
        begun = span.isEmpty() || !(perMetre > 0);
    }

    @Override
    public boolean next() {
        boolean first = !begun;
        begun = true;
        return first;
    }

    @Override
    public double fromMetres() {
        return span.fromMetres();
    }

    @Override
    public double toMetres() {
        return span.toMetres();
    }

    @Override
    public double perMetre() {
        return perMetre;
    }
}
