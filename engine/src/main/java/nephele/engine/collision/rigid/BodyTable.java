package nephele.engine.collision.rigid;

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
 * What never changes about the bodies of a level; they are named by their index. Inertia of even density: box
 * m (b² + c²) / 12, sphere 2 m r² / 5, capsule as a cylinder and two half balls, joined by Steiner's theorem.
 */
public final class BodyTable {
    static final int SPHERE = 0;
    static final int CAPSULE = 1;
    static final int BOX = 2;

    private final List<Body> bodies;
    private final int[] kind;
    /** Three half edges of a box; half axis (of y) and radius as 1 and 2 of a capsule; radius as 2 of a sphere. */
    private final double[] half;
    /** Per kilogram and per kilogram square metre: reciprocal mass and the three principal inertias' reciprocals. */
    private final double[] inverse;

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
        double moment = 0.4 * sphere.massKilograms() * sphere.radiusMetres() * sphere.radiusMetres();
        kind[i] = SPHERE;
        halves(i, 0, 0, sphere.radiusMetres());
        inverses(i, sphere.massKilograms(), moment, moment, moment);
    }

    private void addCapsule(int i, Body.Capsule capsule) {
        double r = capsule.radiusMetres();
        double h = Math.max(0, capsule.heightMetres() - 2 * r);
        double ballShare = 4 * r / (4 * r + 3 * h);
        double ball = capsule.massKilograms() * ballShare;
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

    public int size() {
        return kind.length;
    }

    /** The body as the author wrote it. */
    public Body body(int body) {
        return bodies.get(body);
    }

    public double massKilograms(int body) {
        return bodies.get(body).massKilograms();
    }

    /** Every body at rest where the level puts it, awake. */
    public Bodies start() {
        List<BodyState> states = new ArrayList<>(size());
        for (Body body : bodies) {
            states.add(BodyState.resting(body.centre()));
        }
        return Bodies.of(states);
    }

    /** The shape before any turn, around the centre of mass. */
    public RoundedHull uprightHull(int body) {
        double r = half[3 * body + 2];
        return switch (kind[body]) {
            case SPHERE -> RoundedHull.sphere(r);
            case CAPSULE -> RoundedHull.capsule(new Vec3(0, half[3 * body + 1], 0), r);
            default ->
                RoundedHull.box(new Vec3(half[3 * body], 0, 0), new Vec3(0, half[3 * body + 1], 0), new Vec3(0, 0, r));
        };
    }

    /** The shape of a body that is turned like this, around the centre of mass. */
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

    /** A body as an obstacle for who sweeps past it. */
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

    /** The radius of the ball around the centre that holds the body, however it is turned. */
    public double reachMetres(int body) {
        double x = half[3 * body];
        double y = half[3 * body + 1];
        double z = half[3 * body + 2];
        return kind[body] == BOX ? Math.sqrt(x * x + y * y + z * z) : y + z;
    }

    /** Whether a body whose centre is here, before a portal, may reach through it. */
    public boolean mayReachThrough(int body, Vector3dc centre, Portal portal) {
        double height = portal.inFront(centre.x(), centre.y(), centre.z());
        return height >= 0 && height < reachMetres(body) && mayReachBeside(body, centre, portal);
    }

    /** Whether a body whose centre is here, at any depth, may reach over or under a portal's aperture. */
    public boolean mayReachBeside(int body, Vector3dc centre, Portal portal) {
        double x = portal.across(centre.x(), centre.y(), centre.z());
        double y = portal.upward(centre.x(), centre.y(), centre.z());
        return portal.aperture().outside(x, y) < reachMetres(body);
    }

    /** Whether all moments of inertia are equal: then no turn changes the energy of a spin. */
    boolean isEven(int body) {
        double x = inverseInertia(body, 0);
        return x == inverseInertia(body, 1) && x == inverseInertia(body, 2);
    }

    /** The greatest extent of a body by its least. */
    double slenderness(int body) {
        double x = half[3 * body];
        double y = half[3 * body + 1];
        double z = half[3 * body + 2];
        return kind[body] == BOX ? Math.max(x, Math.max(y, z)) / Math.min(x, Math.min(y, z)) : (y + z) / z;
    }

    int kind(int body) {
        return kind[body];
    }

    double half(int body, int axis) {
        return half[3 * body + axis];
    }

    double inverseMass(int body) {
        return inverse[4 * body];
    }

    /** Reciprocal of a principal moment of inertia, in the body's axes. */
    double inverseInertia(int body, int axis) {
        return inverse[4 * body + 1 + axis];
    }
}
