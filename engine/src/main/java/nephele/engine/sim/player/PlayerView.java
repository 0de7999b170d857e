package nephele.engine.sim.player;

import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import nephele.engine.sim.state.Tilt;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The view angles of the player and the tilt of body and view. A portal maps the view exactly: the view angles hold
 * what fits into whole thousandths of a degree, the tilt the remainder.
 */
public record PlayerView(ViewAngles heading, Tilt tilt) {
    /**
     * The horizontal part of the view direction below which the yaw is derived from the up vector: steeper than the
     * steepest pitch.
     */
    private static final double STEEP = StrictMath.cos(Math.toRadians(89.9));

    /** Returns the camera basis of the view, in world directions. */
    public Basis view() {
        Basis level = Basis.ofYawPitch(heading.yawRadians(), heading.pitchRadians());
        Quaterniond turn = tilt.view();
        return new Basis(turned(turn, level.right()), turned(turn, level.up()), turned(turn, level.back()));
    }

    private static Vec3 turned(Quaterniond turn, Vec3 v) {
        Vector3d turned = turn.transform(v.toVector());
        return new Vec3(turned.x, turned.y, turned.z);
    }

    PlayerView through(PortalTransform transform) {
        Basis before = view();
        Vec3 right = transform.direction(before.right());
        Vec3 up = transform.direction(before.up());
        Vec3 back = transform.direction(before.back());
        ViewAngles nearest = nearest(up, back);
        Basis level = Basis.ofYawPitch(nearest.yawRadians(), nearest.pitchRadians());
        Quaterniond rest = Rotations.ofAxes(right, up, back);
        rest.mul(Rotations.ofAxes(level.right(), level.up(), level.back()).conjugate());
        return new PlayerView(nearest, Tilt.of(transform.direction(tilt.up()), Rotations.normalised(rest)));
    }

    private static ViewAngles nearest(Vec3 up, Vec3 back) {
        double flat = Math.sqrt(back.x() * back.x() + back.z() * back.z());
        double pitch = StrictMath.atan2(-back.y(), flat);
        double yaw = StrictMath.atan2(back.x(), back.z());
        if (flat < STEEP) {
            yaw = back.y() < 0 ? StrictMath.atan2(up.x(), up.z()) : StrictMath.atan2(-up.x(), -up.z());
        }
        return ViewAngles.ofDegrees(Math.toDegrees(yaw), Math.toDegrees(pitch));
    }
}
