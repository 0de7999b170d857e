package nephele.engine.portal;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.PortalSpec;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * One end of a portal pair: a place in the world with an opening. It faces along {@code frame.back()}, away from its
 * wall; x and y of the {@link Aperture} are {@code frame.right()} and {@code frame.up()}.
 *
 * @param id as in the level, or the colour of the shot
 */
public record Portal(String id, Vec3 centre, Basis frame, Aperture aperture) {
    /**
     * Makes a portal.
     *
     * @param spec as the level rules allow it: the normal is not zero, up not parallel to it
     */
    public static Portal of(PortalSpec spec) {
        Basis frame = facing(spec.normal(), spec.up());
        return new Portal(
                spec.id(), spec.centre(), frame, Aperture.of(spec.shape(), spec.widthMetres(), spec.heightMetres()));
    }

    /** Returns the frame that faces along {@code normal}, with its up axis as close to {@code up} as possible. */
    public static Basis facing(Vec3 normal, Vec3 up) {
        Vec3 behind = normal.negated();
        return Basis.lookAt(Vec3.ZERO, behind, up, Basis.WORLD);
    }

    /** Returns the unit normal, away from the wall. */
    public Vec3 normal() {
        return frame.back();
    }

    /** Returns the aperture's corners in the world, counter-clockwise seen from the front. */
    public List<Vec3> corners() {
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < aperture.corners(); i++) {
            corners.add(world(aperture.cornerX(i), aperture.cornerY(i), 0));
        }
        return corners;
    }

    /** Returns the distance of a point in front of the portal's plane in metres, negative behind it. */
    public double inFront(double x, double y, double z) {
        return along(frame.back(), x, y, z);
    }

    /** Returns the distance of a point to the right of the centre, in metres. */
    public double across(double x, double y, double z) {
        return along(frame.right(), x, y, z);
    }

    /** Returns the distance of a point above the centre along the portal's up axis, in metres. */
    public double upward(double x, double y, double z) {
        return along(frame.up(), x, y, z);
    }

    private double along(Vec3 axis, double x, double y, double z) {
        return axis.x() * (x - centre.x()) + axis.y() * (y - centre.y()) + axis.z() * (z - centre.z());
    }

    /** Returns the point in the world with these coordinates in the portal's frame. */
    public Vec3 world(double across, double upward, double inFront) {
        Vector3d p = centre.toVector()
                .fma(across, frame.right().toVector())
                .fma(upward, frame.up().toVector())
                .fma(inFront, frame.back().toVector());
        return new Vec3(p.x, p.y, p.z);
    }
}
