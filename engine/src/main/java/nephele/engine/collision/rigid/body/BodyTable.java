package nephele.engine.collision.rigid.body;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.RoundedHull;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The constant properties of a level's bodies, by index. Inertia of uniform density: box m (b² + c²) / 12, sphere 2 m
 * r² / 5, capsule as a cylinder and two hemispheres, joined by the parallel axis theorem.
 */
public final class BodyTable {
    public static final int SPHERE = 0;
    public static final int CAPSULE = 1;
    public static final int BOX = 2;

    private final List<Body> bodies;
    private final int[] kind;
    /**
     * Three numbers a body. Box: its half edges. Capsule: 1 is the half axis (along y), 2 the radius. Sphere: 2 is the
     * radius.
     */
    private final double[] half;
    /** Four numbers a body: reciprocal mass (1/kg) and reciprocals of the principal moments of inertia (1/(kg m²)). */
    private final double[] inverse;

    /** Makes a table of these bodies; their indices are those in the list. */
    public BodyTable(List<Body> bodies) {
        this.bodies = List.copyOf(bodies);
        kind = new int[bodies.size()];
        half = new double[3 * bodies.size()];
        inverse = new double[4 * bodies.size()];
        for (int i = 0; i < bodies.size(); i++) {
            Body body = bodies.get(i);
            if (body instanceof Body.Box box) {
                addBox(i, box);
            } else if (body instanceof Body.Sphere sphere) {
                addSphere(i, sphere);
            } else if (body instanceof Body.Capsule capsule) {
                addCapsule(i, capsule);
            }
        }
    }

    /** Returns the table of a level's bodies, in the order of the level. */
    public static BodyTable of(Level level) {
        return new BodyTable(level.bodies());
    }

    private void addBox(int i, Body.Box box) {
        Vec3 s = box.size();
        double m = box.massKilograms() / 12;
        kind[i] = BOX;
        halves(i, s.x() / 2, s.y() / 2, s.z() / 2);
        inverses(
                i,
                box.massKilograms(),
                m * (s.y() * s.y() + s.z() * s.z()),
                m * (s.z() * s.z() + s.x() * s.x()),
                m * (s.x() * s.x() + s.y() * s.y()));
    }

    private void addSphere(int i, Body.Sphere sphere) {
        double frameState = 0.4 * sphere.massKilograms() * sphere.radiusMetres() * sphere.radiusMetres();
        kind[i] = SPHERE;
        halves(i, 0, 0, sphere.radiusMetres());
        inverses(i, sphere.massKilograms(), frameState, frameState, frameState);
    }

    private void addCapsule(int i, Body.Capsule capsule) {
        double r = capsule.radiusMetres();
        double h = Math.max(0, capsule.heightMetres() - 2 * r);
        double ballFraction = 4 * r / (4 * r + 3 * h);
        double ball = capsule.massKilograms() * ballFraction;
        double tube = capsule.massKilograms() - ball;
        double along = tube * r * r / 2 + ball * 0.4 * r * r;
        double across = tube * (r * r / 4 + h * h / 12) + ball * (0.4 * r * r + h * h / 4 + 3 * h * r / 8);
        kind[i] = CAPSULE;
        halves(i, 0, h / 2, r);
        inverses(i, capsule.massKilograms(), across, along, across);
    }

    private void halves(int i, double x, double y, double z) {
        half[3 * i] = x;
        half[3 * i + 1] = y;
        half[3 * i + 2] = z;
    }

    private void inverses(int i, double mass, double x, double y, double z) {
        inverse[4 * i] = 1 / mass;
        inverse[4 * i + 1] = 1 / x;
        inverse[4 * i + 2] = 1 / y;
        inverse[4 * i + 3] = 1 / z;
    }

    /** Returns the number of bodies. */
    public int size() {
        return kind.length;
    }

    /** Returns the body as the level describes it. */
    public Body body(int body) {
        return bodies.get(body);
    }

    /** Returns a body's mass. */
    public double massKilograms(int body) {
        return bodies.get(body).massKilograms();
    }

    /** Returns every body at rest at its place in the level, awake. */
    public Bodies start() {
        List<BodyState> states = new ArrayList<>(size());
        for (Body body : bodies) {
            states.add(BodyState.resting(body.centre()));
        }
        return Bodies.of(states);
    }

    /** Returns the unrotated shape, around the centre of mass. */
    public RoundedHull uprightHull(int body) {
        double r = half[3 * body + 2];
        return switch (kind[body]) {
            case SPHERE -> RoundedHull.sphere(r);
            case CAPSULE -> RoundedHull.capsule(new Vec3(0, half[3 * body + 1], 0), r);
            default ->
                RoundedHull.box(new Vec3(half[3 * body], 0, 0), new Vec3(0, half[3 * body + 1], 0), new Vec3(0, 0, r));
        };
    }

    /** Returns the shape of a body with this orientation, around the centre of mass. */
    public RoundedHull hull(int body, Quaterniond orientation) {
        double r = half[3 * body + 2];
        return switch (kind[body]) {
            case SPHERE -> RoundedHull.sphere(r);
            case CAPSULE -> RoundedHull.capsule(turned(orientation, 0, half[3 * body + 1], 0), r);
            default ->
                RoundedHull.box(
                        turned(orientation, half[3 * body], 0, 0),
                        turned(orientation, 0, half[3 * body + 1], 0),
                        turned(orientation, 0, 0, r));
        };
    }

    /** Returns a body as an obstacle for sweeps. */
    public Collider collider(int body, Vector3dc centre, Quaterniond orientation) {
        Vec3 at = Vec3.of(centre);
        String id = bodies.get(body).id();
        double r = half[3 * body + 2];
        Vec3 halfY = turned(orientation, 0, half[3 * body + 1], 0);
        if (kind[body] != BOX) {
            return Collider.capsule(id, at, halfY, r);
        }
        Vec3 halfX = turned(orientation, half[3 * body], 0, 0);
        return new Collider(id, ConvexPolyhedron.box(at, halfX, halfY, turned(orientation, 0, 0, r)));
    }

    private static Vec3 turned(Quaterniond orientation, double x, double y, double z) {
        return Vec3.of(orientation.transform(new Vector3d(x, y, z)));
    }

    /** Returns the radius of the bounding sphere around the body's centre. */
    public double reachMetres(int body) {
        double x = half[3 * body];
        double y = half[3 * body + 1];
        double z = half[3 * body + 2];
        return kind[body] == BOX ? Math.sqrt(x * x + y * y + z * z) : y + z;
    }

    /** Returns true if a body with its centre here, in front of a portal, may reach through it. */
    public boolean mayReachThrough(int body, Vector3dc centre, Portal portal) {
        double height = portal.inFront(centre.x(), centre.y(), centre.z());
        return height >= 0 && height < reachMetres(body) && mayReachBeside(body, centre, portal);
    }

    /**
     * Returns true if a body with its centre here, in front of or behind a portal's plane, may overlap the aperture's
     * prism.
     */
    public boolean mayReachBeside(int body, Vector3dc centre, Portal portal) {
        double x = portal.across(centre.x(), centre.y(), centre.z());
        double y = portal.upward(centre.x(), centre.y(), centre.z());
        return portal.aperture().outside(x, y) < reachMetres(body);
    }

    /**
     * Returns true if all moments of inertia are equal: then rotation does not change the energy of an angular
     * velocity.
     */
    public boolean isEven(int body) {
        double x = inverseInertia(body, 0);
        return x == inverseInertia(body, 1) && x == inverseInertia(body, 2);
    }

    /** Returns the ratio of a body's greatest to its least extent. */
    public double slenderness(int body) {
        double x = half[3 * body];
        double y = half[3 * body + 1];
        double z = half[3 * body + 2];
        return kind[body] == BOX ? Math.max(x, Math.max(y, z)) / Math.min(x, Math.min(y, z)) : (y + z) / z;
    }

    public int kind(int body) {
        return kind[body];
    }

    public double half(int body, int axis) {
        return half[3 * body + axis];
    }

    public double inverseMass(int body) {
        return inverse[4 * body];
    }

    /** Returns the reciprocal of a principal moment of inertia, in the body's axes. */
    public double inverseInertia(int body, int axis) {
        return inverse[4 * body + 1 + axis];
    }
}
