package nephele.editor.pane;

import java.util.Optional;
import nephele.engine.math.Basis;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A perspective camera. Yaw 0 looks along −z, positive to the left; pitch is positive upwards.
 *
 * @param verticalFovDegrees full angle between the lower and the upper border
 */
public record PerspectiveCamera(Vec3 eye, double yawDegrees, double pitchDegrees, double verticalFovDegrees)
        implements PaneCamera {
    private static final double STEEPEST_DEGREES = 89.9;

    public PerspectiveCamera {
        pitchDegrees = Math.max(-STEEPEST_DEGREES, Math.min(STEEPEST_DEGREES, pitchDegrees));
    }

    private Basis basis() {
        return Basis.ofYawPitch(Math.toRadians(yawDegrees), Math.toRadians(pitchDegrees));
    }

    @Override
    public Ray ray(double x, double y, PaneSize size) {
        double half = Math.tan(Math.toRadians(verticalFovDegrees) / 2);
        double across = (2 * x / size.width() - 1) * half * size.aspect();
        double upward = (1 - 2 * y / size.height()) * half;
        Basis basis = basis();
        Vec3 direction = basis.back().negated().addScaled(across, basis.right()).addScaled(upward, basis.up());
        return Ray.of(eye, direction.scaled(1 / direction.length()));
    }

    @Override
    public Optional<PanePoint> project(Vec3 point, PaneSize size) {
        Basis basis = basis();
        Vec3 seen = point.minus(eye);
        double depth = -seen.dot(basis.back());
        if (!(depth > 1e-6)) {
            return Optional.empty();
        }
        double half = depth * Math.tan(Math.toRadians(verticalFovDegrees) / 2);
        double x = (1 + seen.dot(basis.right()) / (half * size.aspect())) * size.width() / 2;
        double y = (1 - seen.dot(basis.up()) / half) * size.height() / 2;
        return Optional.of(new PanePoint(x, y, depth));
    }

    @Override
    public double metresPerPixel(Vec3 at, PaneSize size) {
        double depth = Math.max(1e-3, at.minus(eye).dot(forward()));
        return 2 * depth * Math.tan(Math.toRadians(verticalFovDegrees) / 2) / size.height();
    }

    @Override
    public Vec3 right() {
        return basis().right();
    }

    @Override
    public Vec3 up() {
        return basis().up();
    }

    @Override
    public Vec3 forward() {
        return basis().back().negated();
    }
}
