package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.math.Directions;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;

/**
 * How far a portal has left the player from upright: body and view lean apart, since the body turns as room allows and
 * the view does not wait for it. A value.
 *
 * @param up unit vector from the feet to the head
 * @param x of the unit quaternion by which the view is turned after the heading, in the world; y, z and w alike
 */
public record Tilt(Vec3 up, double x, double y, double z, double w) {
    private static final Vec3 VERTICAL = new Vec3(0, 1, 0);
    public static final Tilt UPRIGHT = new Tilt(VERTICAL, 0, 0, 0, 1);

    /** What rounding leaves of a passage that keeps everything level. */
    private static final double ROUNDING = 1e-12;

    static Tilt of(Vec3 up, Quaterniond view) {
        boolean level = up.y() > 0 && Math.abs(up.x()) < ROUNDING && Math.abs(up.z()) < ROUNDING;
        Vec3 body = level ? VERTICAL : up;
        boolean straight = Math.abs(view.x) < ROUNDING && Math.abs(view.y) < ROUNDING && Math.abs(view.z) < ROUNDING;
        return straight ? new Tilt(body, 0, 0, 0, 1) : new Tilt(body, view.x, view.y, view.z, view.w);
    }

    /** World from the directions of the heading's view. */
    public Quaterniond view() {
        return new Quaterniond(x, y, z, w);
    }

    public boolean isBodyUpright() {
        return up.equals(VERTICAL);
    }

    boolean isViewLevel() {
        return w == 1;
    }

    boolean isUpright() {
        return equals(UPRIGHT);
    }

    boolean isFinite() {
        return Double.isFinite(up.x() + up.y() + up.z()) && Double.isFinite(x + y + z + w);
    }

    Tilt withBody(Vec3 turned) {
        return new Tilt(turned, x, y, z, w);
    }

    /** The body's axis nearer to vertical by an angle; head over feet in the direction {@code forward} when upside down. */
    Vec3 bodyNearer(double radians, Vec3 forward) {
        double angle = Directions.angle(up, VERTICAL);
        if (angle <= radians) {
            return VERTICAL;
        }
        boolean upsideDown = angle > Math.PI - 1e-6;
        return upsideDown
                ? Directions.turned(up, forward, radians / (Math.PI / 2))
                : Directions.turned(up, VERTICAL, radians / angle);
    }

    /** The view nearer to where the heading looks. */
    Tilt viewNearer(double radians) {
        double angle = 2 * StrictMath.atan2(Math.sqrt(x * x + y * y + z * z), Math.abs(w));
        if (angle <= radians) {
            return new Tilt(up, 0, 0, 0, 1);
        }
        Quaterniond nearer = Rotations.slerp(view(), new Quaterniond(), radians / angle);
        return new Tilt(up, nearer.x, nearer.y, nearer.z, nearer.w);
    }

    /** An upright player has none, as in levels without portals. */
    long hash(long seed) {
        if (isUpright()) {
            return seed;
        }
        long hash = BitHash.join(BitHash.join(seed, up), Double.doubleToLongBits(x));
        hash = BitHash.join(BitHash.join(hash, Double.doubleToLongBits(y)), Double.doubleToLongBits(z));
        return BitHash.join(hash, Double.doubleToLongBits(w));
    }
}
