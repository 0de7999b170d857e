package nephele.engine.model.bound;

import nephele.engine.math.Chance;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * A place and a direction of a rigid body.
 *
 * @param x where its x axis points in the world, unit length
 * @param y where its y axis points, unit length
 * @param z where its z axis points, unit length
 * @param at where its origin is, metres
 */
public record Pose(Vec3 x, Vec3 y, Vec3 z, Vec3 at) {
    public static Pose turned(Quaterniond by, Vec3 at) {
        return new Pose(
                Vec3.of(by.transform(new Vector3d(1, 0, 0))),
                Vec3.of(by.transform(new Vector3d(0, 1, 0))),
                Vec3.of(by.transform(new Vector3d(0, 0, 1))),
                at);
    }

    /**
     * Returns a pose whose rotation is uniform among all (Shoemake 1992, "Uniform random rotations").
     *
     * @param purpose of the first of three random numbers
     */
    public static Pose random(long dice, int purpose, Vec3 at) {
        double fraction = Chance.unit(dice, purpose);
        double first = 2 * Math.PI * Chance.unit(dice, purpose + 1);
        double second = 2 * Math.PI * Chance.unit(dice, purpose + 2);
        double small = Math.sqrt(1 - fraction);
        double large = Math.sqrt(fraction);
        var turn = new Quaterniond(
                small * Math.sin(first), small * Math.cos(first), large * Math.sin(second), large * Math.cos(second));
        return turned(new Quaterniond(Rotations.normalised(turn)), at);
    }

    /** Returns where a point of the body is in the world. */
    public Vec3 moved(Vec3 point) {
        return at.addScaled(point.x(), x).addScaled(point.y(), y).addScaled(point.z(), z);
    }

    /** Returns where a point of the world is in the body's coordinates. */
    public Vec3 local(Vec3 point) {
        return turnedBack(point.minus(at));
    }

    public Pose movedTo(Vec3 place) {
        return new Pose(x, y, z, place);
    }

    /** Returns the pose of this body as another one sees it. */
    public Pose relativeTo(Pose other) {
        return new Pose(
                other.turnedBack(x), other.turnedBack(y), other.turnedBack(z), other.turnedBack(at.minus(other.at)));
    }

    private Vec3 turnedBack(Vec3 direction) {
        return new Vec3(direction.dot(x), direction.dot(y), direction.dot(z));
    }
}
