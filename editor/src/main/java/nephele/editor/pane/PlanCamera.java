package nephele.editor.pane;

import java.util.Optional;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * An orthographic camera along an axis of the world.
 *
 * @param kind not {@link PaneKind#PERSPECTIVE}
 * @param centre the point in the middle of the picture
 */
public record PlanCamera(PaneKind kind, Vec3 centre, double metresPerPixel) implements PaneCamera {
    /** Rays begin this far before the centre, beyond every level. */
    private static final double START_METRES = 2e7;

    public PlanCamera {
        if (kind == PaneKind.PERSPECTIVE) {
            throw new IllegalArgumentException("a perspective pane has a PerspectiveCamera");
        }
    }

    @Override
    public Ray ray(double x, double y, PaneSize size) {
        Vec3 on = centre.addScaled((x - size.width() / 2.0) * metresPerPixel, right())
                .addScaled((size.height() / 2.0 - y) * metresPerPixel, up());
        return Ray.of(on.addScaled(-START_METRES, forward()), forward());
    }

    @Override
    public Optional<PanePoint> project(Vec3 point, PaneSize size) {
        Vec3 seen = point.minus(centre);
        double x = size.width() / 2.0 + seen.dot(right()) / metresPerPixel;
        double y = size.height() / 2.0 - seen.dot(up()) / metresPerPixel;
        return Optional.of(new PanePoint(x, y, START_METRES + seen.dot(forward())));
    }

    @Override
    public double metresPerPixel(Vec3 at, PaneSize size) {
        return metresPerPixel;
    }

    @Override
    public Vec3 right() {
        return kind == PaneKind.SIDE ? new Vec3(0, 0, -1) : new Vec3(1, 0, 0);
    }

    @Override
    public Vec3 up() {
        return kind == PaneKind.TOP ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
    }

    @Override
    public Vec3 forward() {
        return switch (kind) {
            case TOP -> new Vec3(0, -1, 0);
            case FRONT -> new Vec3(0, 0, -1);
            case SIDE -> new Vec3(-1, 0, 0);
            case PERSPECTIVE -> throw new IllegalStateException("no plan");
        };
    }
}
