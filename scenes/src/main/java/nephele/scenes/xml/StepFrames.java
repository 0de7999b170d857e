package nephele.scenes.xml;

import java.util.List;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlGroup.Step;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/** The frame of a group: its steps at a time, within the frame around it. */
final class StepFrames {
    private final List<Step> steps;
    private final CurveFrame[] curves;
    private final Vec3[] axes;
    private final StepFrames parent;
    private final boolean moves;
    private final Matrix4d worldFromGroup = new Matrix4d();
    private final Matrix4d part = new Matrix4d();

    /** @param parent {@code null} for the world */
    StepFrames(StepFrames parent, List<Step> steps) {
        this.parent = parent;
        this.steps = steps;
        moves = parent != null && parent.moves
                || steps.stream().anyMatch(step -> step instanceof Step.Follow || step instanceof Step.Spin);
        curves = new CurveFrame[steps.size()];
        axes = new Vec3[steps.size()];
        for (int i = 0; i < curves.length; i++) {
            Step step = steps.get(i);
            curves[i] = step instanceof Step.Follow follow ? new CurveFrame(follow.points()) : null;
            axes[i] = step instanceof Step.Rotate rotate
                    ? Directions.unit(rotate.axis())
                    : step instanceof Step.Spin spin ? Directions.unit(spin.axis()) : null;
        }
    }

    /** Returns true if the frame may change with time. */
    boolean moves() {
        return moves;
    }

    /** Returns the frame at the time of the last {@link #at}: always the same object. */
    Matrix4dc worldFromGroup() {
        return worldFromGroup;
    }

    /** Computes the frame, after its parent's; the first step is the outermost. */
    void at(double seconds) {
        Matrix4d frame = worldFromGroup;
        if (parent == null) {
            frame.identity();
        } else {
            frame.set(parent.worldFromGroup);
        }
        for (int i = 0; i < curves.length; i++) {
            Step step = steps.get(i);
            if (step instanceof Step.Translate translate) {
                frame.translate(
                        translate.by().x(), translate.by().y(), translate.by().z());
            } else if (step instanceof Step.Scale scale) {
                frame.scale(scale.by().x(), scale.by().y(), scale.by().z());
            } else if (step instanceof Step.Rotate rotate) {
                rotate(frame, axes[i], rotate.angleDegrees());
            } else if (step instanceof Step.Spin spin) {
                double turns = seconds / spin.seconds();
                rotate(frame, axes[i], 360 * (turns - Math.floor(turns)));
            } else if (step instanceof Step.Follow follow) {
                follow(frame, curves[i], follow, seconds);
            }
        }
    }

    private void follow(Matrix4d frame, CurveFrame curve, Step.Follow follow, double seconds) {
        if (follow.align()) {
            curve.carryAligned(seconds / follow.seconds(), frame, part);
        } else {
            curve.carry(seconds / follow.seconds(), frame);
        }
    }

    /**
     * Rotates by Rodrigues' formula; quarter turns are exact. @param unit {@code null} for an axis without direction
     */
    private void rotate(Matrix4d frame, Vec3 unit, double degrees) {
        if (unit == null) {
            return;
        }
        double x = unit.x();
        double y = unit.y();
        double z = unit.z();
        double sin = sine(degrees);
        double cos = sine(degrees + 90);
        double rest = 1 - cos;
        part.set(
                cos + rest * x * x,
                rest * x * y + sin * z,
                rest * x * z - sin * y,
                0,
                rest * x * y - sin * z,
                cos + rest * y * y,
                rest * y * z + sin * x,
                0,
                rest * x * z + sin * y,
                rest * y * z - sin * x,
                cos + rest * z * z,
                0,
                0,
                0,
                0,
                1);
        frame.mul(part);
    }

    private static double sine(double degrees) {
        double quarters = Math.rint(degrees / 90);
        double within = Math.toRadians(degrees - 90 * quarters);
        return switch ((int) Math.floorMod((long) quarters, 4L)) {
            case 0 -> Math.sin(within);
            case 1 -> Math.cos(within);
            case 2 -> -Math.sin(within);
            default -> -Math.cos(within);
        };
    }
}
