package nephele.engine.sim;

import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Where the player looks and how body and view lean. Through a portal the view goes exactly: the heading takes what it
 * can in whole thousandths of a degree, the tilt the rest.
 */
record Look(Heading heading, Tilt tilt) {
    /** Nearer to straight up or down than the steepest pitch, "up" tells the yaw. */
    private static final double STEEP = StrictMath.cos(Math.toRadians(89.9));

    /** World directions of the view: what its picture is drawn with. */
    Basis view() {
        Basis level = Basis.ofYawPitch(heading.yawRadians(), heading.pitchRadians());
        Quaterniond turn = tilt.view();
        return new Basis(turned(turn, level.right()), turned(turn, level.up()), turned(turn, level.back()));
    }

    private static Vec3 turned(Quaterniond turn, Vec3 v) {
        Vector3d turned = turn.transform(v.toVector());
        return new Vec3(turned.x, turned.y, turned.z);
    }

    Look through(Passage passage) {
        Basis before = view();
        Vec3 right = passage.direction(before.right());
        Vec3 up = passage.direction(before.up());
        Vec3 back = passage.direction(before.back());
        Heading nearest = nearest(up, back);
        Basis level = Basis.ofYawPitch(nearest.yawRadians(), nearest.pitchRadians());
        Quaterniond rest = Rotations.ofAxes(right, up, back);
        rest.mul(Rotations.ofAxes(level.right(), level.up(), level.back()).conjugate());
        return new Look(nearest, Tilt.of(passage.direction(tilt.up()), Rotations.renormalised(rest)));
    }

    private static Heading nearest(Vec3 up, Vec3 back) {
        double flat = Math.sqrt(back.x() * back.x() + back.z() * back.z());
        double pitch = StrictMath.atan2(-back.y(), flat);
        double yaw = StrictMath.atan2(back.x(), back.z());
        if (flat < STEEP) {
            yaw = back.y() < 0 ? StrictMath.atan2(up.x(), up.z()) : StrictMath.atan2(-up.x(), -up.z());
        }
        return Heading.ofDegrees(Math.toDegrees(yaw), Math.toDegrees(pitch));
    }
}
