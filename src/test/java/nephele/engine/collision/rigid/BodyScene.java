package nephele.engine.collision.rigid;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** A few solids, portals and bodies, and the simulation of the bodies. */
final class BodyScene {
    static final Vec3 GRAVITY = new Vec3(0, -9.81, 0);

    private final List<Collider> solids = new ArrayList<>();
    private final List<Portal> portals = new ArrayList<>();
    private final List<Integer> partners = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private final List<BodyState> states = new ArrayList<>();
    private Vec3 gravity = GRAVITY;
    private PortalWorld surroundings;
    private RigidStep step;
    final BodyInfluences influences = new BodyInfluences();
    Bodies now;

    BodyScene box(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
        Aabb box = new Aabb(minX, minY, minZ, maxX, maxY, maxZ);
        solids.add(new Collider("s" + solids.size(), ConvexPolyhedron.box(box)));
        return this;
    }

    BodyScene floor() {
        return box(-50, -1, -50, 50, 0, 50);
    }

    BodyScene weightless() {
        gravity = Vec3.ZERO;
        return this;
    }

    BodyScene gravity(Vec3 metresPerSecond2) {
        gravity = metresPerSecond2;
        return this;
    }

    /** Adds two rectangular portals that lead to each other. */
    BodyScene pair(Vec3 centreA, Vec3 normalA, Vec3 centreB, Vec3 normalB, double width, double height) {
        return pair(portal(centreA, normalA, width, height), portal(centreB, normalB, width, height));
    }

    BodyScene pair(Portal a, Portal b) {
        int first = portals.size();
        portals.add(a);
        portals.add(b);
        partners.add(first + 1);
        partners.add(first);
        return this;
    }

    static Portal portal(Vec3 centre, Vec3 normal, double width, double height) {
        return portal(centre, normal, Aperture.of(PortalShape.RECTANGLE, width, height));
    }

    static Portal portal(Vec3 centre, Vec3 normal, Aperture aperture) {
        Vec3 up = Math.abs(normal.y()) > 0.9 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        return new Portal("p", centre, Portal.facing(normal, up), aperture);
    }

    int cube(double size, Vec3 at) {
        return add(new Body.Box("b" + bodies.size(), at, new Vec3(size, size, size), 1, null, 0.6, 0));
    }

    int add(Body body) {
        bodies.add(body);
        states.add(BodyState.resting(body.centre()));
        return bodies.size() - 1;
    }

    BodyScene start() {
        BodyTable table = new BodyTable(bodies);
        step = new RigidStep(table, gravity);
        now = Bodies.of(states);
        return open(new Portals(portals, partners));
    }

    /** Replaces the portals. */
    BodyScene open(Portals open) {
        surroundings = PortalWorld.of(new CollisionWorld(solids), open);
        return this;
    }

    Portals portals() {
        return surroundings.portals();
    }

    BodyScene set(int body, BodyState state) {
        now = now.with(body, state);
        return this;
    }

    BodyScene velocity(int body, Vec3 velocity, Vec3 spin) {
        return set(body, now.state(body).moving(velocity, spin));
    }

    void tick(double seconds) {
        now = step.step(now, surroundings, influences, seconds);
    }

    BodyScene run(double seconds, double ticksPerSecond) {
        long ticks = Math.round(seconds * ticksPerSecond);
        for (long i = 0; i < ticks; i++) {
            tick(1 / ticksPerSecond);
        }
        return this;
    }

    Vector3d centre(int body) {
        return now.centre(body, new Vector3d());
    }

    Vector3d velocity(int body) {
        return now.velocity(body, new Vector3d());
    }

    Vector3d spin(int body) {
        return now.spin(body, new Vector3d());
    }

    Quaterniond orientation(int body) {
        return now.orientation(body, new Quaterniond());
    }
}
