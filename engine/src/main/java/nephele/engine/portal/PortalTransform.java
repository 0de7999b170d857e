package nephele.engine.portal;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Isometry;
import nephele.engine.math.Plane;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The portal transform: the rigid map from the space in front of one portal to the space in front of its partner. It
 * rotates by half a revolution about the entry's up axis and then to the exit's frame; it preserves lengths, angles and
 * handedness. Points are mapped relative to the centres, so that a distant origin costs no precision.
 */
public final class PortalTransform implements Isometry {
    private final Vec3 entry;
    private final Vec3 exit;
    private final Matrix3d rotation;
    private final Quaterniond turn;

    private PortalTransform(Vec3 entry, Vec3 exit, Matrix3d rotation) {
        this.entry = entry;
        this.exit = exit;
        this.rotation = rotation;
        turn = Rotations.ofAxes(column(rotation, 0), column(rotation, 1), column(rotation, 2));
    }

    private static Vec3 column(Matrix3d m, int column) {
        return new Vec3(m.get(column, 0), m.get(column, 1), m.get(column, 2));
    }

    /** Returns the map from an entry to an exit. */
    public static PortalTransform between(Portal entry, Portal exit) {
        Basis a = entry.frame();
        Basis b = exit.frame();
        Matrix3d toWorld = columns(b.right().negated(), b.up(), b.back().negated());
        return new PortalTransform(
                entry.centre(),
                exit.centre(),
                toWorld.mul(columns(a.right(), a.up(), a.back()).transpose()));
    }

    private static Matrix3d columns(Vec3 x, Vec3 y, Vec3 z) {
        return new Matrix3d(x.toVector(), y.toVector(), z.toVector());
    }

    /**
     * Maps a point from the entry's space to the exit's, in place, and returns it; a point behind the entry maps to in
     * front of the exit.
     */
    @Override
    public Vector3d point(Vector3d p) {
        p.sub(entry.x(), entry.y(), entry.z());
        return rotation.transform(p).add(exit.x(), exit.y(), exit.z());
    }

    /** Rotates a direction, a velocity or an angular velocity, in place, and returns it. */
    @Override
    public Vector3d direction(Vector3d v) {
        return rotation.transform(v);
    }

    /** Returns a convex solid before the entry as the congruent solid before the exit. */
    public ConvexPolyhedron polyhedron(ConvexPolyhedron solid) {
        List<ConvexPolyhedron.Face> faces = new ArrayList<>();
        for (ConvexPolyhedron.Face face : solid.faces()) {
            List<Vec3> polygon = face.polygon().stream().map(this::point).toList();
            Plane plane = Plane.through(direction(face.plane().normal()), polygon.get(0));
            faces.add(new ConvexPolyhedron.Face(face.planeIndex(), plane, polygon));
        }
        List<Vec3> corners = solid.vertices().stream().map(this::point).toList();
        return new ConvexPolyhedron(List.copyOf(faces), corners, Aabb.of(corners));
    }

    /** Returns the rotated view axes. */
    public Basis basis(Basis view) {
        return new Basis(direction(view.right()), direction(view.up()), direction(view.back()));
    }

    /** Rotates an orientation (world from body) in place, normalises it and returns it. */
    public Quaterniond orientation(Quaterniond worldFromBody) {
        return worldFromBody.premul(turn).normalize();
    }

    /** Returns the rotation of world directions from the entry's to the exit's side. The caller must not change it. */
    public Matrix3d rotation() {
        return rotation;
    }
}
