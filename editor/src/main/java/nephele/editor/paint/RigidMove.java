package nephele.editor.paint;

import nephele.engine.math.Isometry;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

/**
 * A rotation about a point, then a shift.
 *
 * @param rotation unit
 */
public record RigidMove(Quaterniondc rotation, Vec3 about, Vec3 by) implements Isometry {
    /** Returns the move without a rotation. */
    public static RigidMove shift(Vec3 by) {
        return new RigidMove(new Quaterniond(), Vec3.ZERO, by);
    }

    @Override
    public Vector3d point(Vector3d p) {
        return direction(p.sub(about.x(), about.y(), about.z()))
                .add(about.x(), about.y(), about.z())
                .add(by.x(), by.y(), by.z());
    }

    @Override
    public Vector3d direction(Vector3d v) {
        return rotation.transform(v);
    }
}
