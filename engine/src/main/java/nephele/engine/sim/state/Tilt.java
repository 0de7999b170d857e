package nephele.engine.sim.state;

import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Hash64;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The deviation of the player from upright that a portal has left. Body and view have separate ones, as the body turns
 * as room allows and the view does not wait for it. A value.
 *
 * @param up unit vector from the feet to the head
 * @param x of the unit quaternion that turns the view in the world after the view angles; y, z and w alike
 */
public record Tilt(Vec3 up, double x, double y, double z, double w) {
    private static final Vec3 VERTICAL = new Vec3(0, 1, 0);
    public static final Tilt UPRIGHT = new Tilt(VERTICAL, 0, 0, 0, 1);

    /** The greatest component that counts as rounding of a portal transform that keeps everything level. */
    private static final double ROUNDING = 1e-12;

    public static Tilt of(Vec3 up, Quaterniond view) {
        boolean level = up.y() > 0 && Math.abs(up.x()) < ROUNDING && Math.abs(up.z()) < ROUNDING;
        Vec3 body = level ? VERTICAL : up;
        boolean straight = Math.abs(view.x) < ROUNDING && Math.abs(view.y) < ROUNDING && Math.abs(view.z) < ROUNDING;
        return straight ? new Tilt(body, 0, 0, 0, 1) : new Tilt(body, view.x, view.y, view.z, view.w);
    }

    /** Returns the rotation from the directions of the view angles' basis to world directions. */
    public Quaterniond turn() {
        return new Quaterniond(x, y, z, w);
    }

    /** Returns the camera basis of these view angles with this tilt, in world directions. */
    public Basis view(ViewAngles heading) {
        Basis level = Basis.ofYawPitch(heading.yawRadians(), heading.pitchRadians());
        Quaterniond turn = turn();
        return new Basis(turned(turn, level.right()), turned(turn, level.up()), turned(turn, level.back()));
    }

    private static Vec3 turned(Quaterniond turn, Vec3 v) {
        Vector3d turned = turn.transform(v.toVector());
        return new Vec3(turned.x, turned.y, turned.z);
    }

    public boolean isBodyUpright() {
        return up.equals(VERTICAL);
    }

    public boolean isViewLevel() {
        return w == 1;
    }

    public boolean isUpright() {
        return equals(UPRIGHT);
    }

    boolean isFinite() {
        return Double.isFinite(up.x() + up.y() + up.z()) && Double.isFinite(x + y + z + w);
    }

    public Tilt withBody(Vec3 turned) {
        return new Tilt(turned, x, y, z, w);
    }

    /**
     * Returns the body's axis turned towards the vertical by an angle; over the direction {@code forward} if upside
     * down.
     */
    public Vec3 bodyTowardsUpright(double radians, Vec3 forward) {
        double angle = Directions.angle(up, VERTICAL);
        if (angle <= radians) {
            return VERTICAL;
        }
        boolean upsideDown = angle > Math.PI - 1e-6;
        return upsideDown
                ? Directions.slerp(up, forward, radians / (Math.PI / 2))
                : Directions.slerp(up, VERTICAL, radians / angle);
    }

    /** Returns this tilt with the view turned by an angle towards the view angles' basis. */
    public Tilt viewTowardsUpright(double radians) {
        double angle = 2 * StrictMath.atan2(Math.sqrt(x * x + y * y + z * z), Math.abs(w));
        if (angle <= radians) {
            return new Tilt(up, 0, 0, 0, 1);
        }
        Quaterniond nearer = Rotations.slerp(turn(), new Quaterniond(), radians / angle);
        return new Tilt(up, nearer.x, nearer.y, nearer.z, nearer.w);
    }

    /** Joins the tilt to a hash; an upright one does not change it, as in levels without portals. */
    long hash(long seed) {
        if (isUpright()) {
            return seed;
        }
        long hash = Hash64.combine(Hash64.combine(seed, up), Double.doubleToLongBits(x));
        hash = Hash64.combine(Hash64.combine(hash, Double.doubleToLongBits(y)), Double.doubleToLongBits(z));
        return Hash64.combine(hash, Double.doubleToLongBits(w));
    }
}
