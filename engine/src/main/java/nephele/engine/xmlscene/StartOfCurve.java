package nephele.engine.xmlscene;

import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.math.Vec3;
import nephele.engine.xmlscene.XmlGroup.Step;
import org.joml.AxisAngle4d;
import org.joml.Matrix4d;
import org.joml.Quaterniond;

/** How what follows a curve stands at time 0. */
final class StartOfCurve {
    private StartOfCurve() {}

    /** @return {@code null} for no turn */
    static TransformStep turn(Step.Follow follow) {
        if (!follow.align()) {
            return null;
        }
        Matrix4d frame = new Matrix4d();
        new CurveFrame(follow.points()).carryAligned(0, frame, new Matrix4d());
        AxisAngle4d turn = new AxisAngle4d(frame.getNormalizedRotation(new Quaterniond()));
        boolean turns = turn.angle != 0 && Double.isFinite(turn.angle + turn.x + turn.y + turn.z);
        return turns ? new TransformStep.Rotate(new Vec3(turn.x, turn.y, turn.z), Math.toDegrees(turn.angle)) : null;
    }
}
