package nephele.editor.brush;

import nephele.editor.paint.RigidMove;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;

/** A rigid move with the map of points that tests compare with. */
record LockedMove(RigidMove move) {
    static LockedMove turn(Vec3 pivot, Vec3 axis, double degrees) {
        return new LockedMove(new RigidMove(Rotations.aroundAxis(axis, Math.toRadians(degrees)), pivot, Vec3.ZERO));
    }

    static LockedMove shift(Vec3 by) {
        return new LockedMove(RigidMove.shift(by));
    }

    Vec3 point(Vec3 p) {
        return move.point(p);
    }
}
