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
 * The rigid map from the space before one portal to the space before its partner: a turn about the entry's centre by
 * half a revolution around its up, carried to the exit's frame. It keeps lengths, angles and handedness. Points are
 * mapped relative to the centres, so that a portal far from the origin costs no precision.
 */
public final class Passage implements Isometry {
    private final Vec3 entry;
    private final Vec3 exit;
    private final Matrix3d rotation;
    private final Quaterniond turn;

    private Passage(Vec3 entry, Vec3 exit, Matrix3d rotation) {
        this.entry = entry;
        this.exit = exit;
        this.rotation = rotation;
        turn = Rotations.ofAxes(column(rotation, 0), column(rotation, 1), column(rotation, 2));
    }

    private static Vec3 column(Matrix3d m, int column) {
        return new Vec3(m.get(column, 0), m.get(column, 1), m.get(column, 2));
    }

    public static Passage between(Portal entry, Portal exit) {
        Basis a = entry.frame();
        Basis b = exit.frame();
        Matrix3d toWorld = columns(b.right().negated(), b.up(), b.back().negated());
        return new Passage(
                entry.centre(),
                exit.centre(),
                toWorld.mul(columns(a.right(), a.up(), a.back()).transpose()));
    }

    private static Matrix3d columns(Vec3 x, Vec3 y, Vec3 z) {
        return new Matrix3d(x.toVector(), y.toVector(), z.toVector());
    }

    /** Moves a point from before the entry to before the exit. */
    @Override
    public Vector3d point(Vector3d p) {
        p.sub(entry.x(), entry.y(), entry.z());
        return rotation.transform(p).add(exit.x(), exit.y(), exit.z());
    }

    /** Turns a direction, a velocity or an angular velocity. */
    @Override
    public Vector3d direction(Vector3d v) {
        return rotation.transform(v);
    }

    @Override
    public boolean isReflection() {
        return false;
    }

    public Vec3 point(Vec3 p) {
        Vector3d moved = point(p.toVector());
        return new Vec3(moved.x, moved.y, moved.z);
    }

    public Vec3 direction(Vec3 v) {
        Vector3d turned = direction(v.toVector());
        return new Vec3(turned.x, turned.y, turned.z);
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

    /** Turns how one looks. */
    public Basis basis(Basis view) {
        return new Basis(direction(view.right()), direction(view.up()), direction(view.back()));
    }

    /** Turns an orientation (world from body) and makes it unit length again. */
    public Quaterniond orientation(Quaterniond worldFromBody) {
        return worldFromBody.premul(turn).normalize();
    }

    /** World directions after the passage from those before. The caller keeps it unchanged. */
    public Matrix3d rotation() {
        return rotation;
    }
}
