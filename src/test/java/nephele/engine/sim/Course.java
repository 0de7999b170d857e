package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalShape;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;

/** A small world built by a test, and the player in it. Floors have their top at y = 0 unless stated. */
final class Course {
    private final List<Collider> colliders = new ArrayList<>();
    private final Vec3 origin;
    private PlayerStart start;
    private SimSettings settings = SimSettings.DEFAULT;
    private final List<Portal> portals = new ArrayList<>();
    private final List<Integer> partners = new ArrayList<>();
    private Simulation simulation;
    private SimState state;

    Course() {
        this(Vec3.ZERO);
    }

    /** Creates an empty world translated to {@code origin}. */
    Course(Vec3 origin) {
        this.origin = origin;
        start = new PlayerStart(origin, 0, 0);
    }

    /** Creates a world of existing colliders. */
    Course(CollisionWorld ready, Vec3 origin) {
        this(origin);
        for (int i = 0; i < ready.size(); i++) {
            colliders.add(ready.collider(i));
        }
    }

    private Vec3 at(double x, double y, double z) {
        return new Vec3(origin.x() + x, origin.y() + y, origin.z() + z);
    }

    static Course onFloor() {
        return new Course().box(-50, -1, -50, 50, 0, 50);
    }

    Course solid(Solid solid) {
        colliders.add(new Collider(solid.id(), Brush.of(solid).shape()));
        return this;
    }

    /** Adds a box by its lower and upper corner. */
    Course box(double x0, double y0, double z0, double x1, double y1, double z1) {
        Vec3 centre = at((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
        return solid(new Solid.Box(
                "box" + colliders.size(), null, false, null, centre, new Vec3(x1 - x0, y1 - y0, z1 - z0), Map.of()));
    }

    /** Adds a slope that rises towards −z, the direction of yaw 0, from z = {@code z1} at y = 0 to z = {@code z0}. */
    Course slope(double z0, double z1, double degrees) {
        double height = (z1 - z0) * StrictMath.tan(Math.toRadians(degrees));
        Vec3 centre = at(0, height / 2, (z0 + z1) / 2);
        return solid(new Solid.Wedge(
                "slope" + colliders.size(),
                null,
                false,
                null,
                centre,
                new Vec3(8, height, z1 - z0),
                BoxFace.MINUS_Z,
                Map.of()));
    }

    /** Adds two linked rectangular portals, 1.2 m wide and 2.1 m high, each by centre, normal and up. */
    Course pair(Vec3[] a, Vec3[] b) {
        return pair(a, b, Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1));
    }

    Course pair(Vec3[] a, Vec3[] b, Aperture aperture) {
        int first = portals.size();
        for (Vec3[] end : new Vec3[][] {a, b}) {
            Vec3 centre = at(end[0].x(), end[0].y(), end[0].z());
            portals.add(new Portal("portal" + portals.size(), centre, Portal.facing(end[1], end[2]), aperture));
        }
        partners.add(first + 1);
        partners.add(first);
        return this;
    }

    Portals portals() {
        return portals.isEmpty() ? Portals.NONE : new Portals(portals, partners);
    }

    Course startAt(double x, double y, double z) {
        start = new PlayerStart(at(x, y, z), 0, 0);
        return this;
    }

    Course with(SimSettings changed) {
        settings = changed;
        return this;
    }

    Course ticksPerSecond(int rate) {
        settings = settings.withTicksPerSecond(rate);
        return this;
    }

    CollisionWorld world() {
        return new CollisionWorld(colliders);
    }

    Simulation simulation() {
        if (simulation == null) {
            simulation = new Simulation(SimLevel.of(world(), start, portals()), settings);
            state = simulation.start();
        }
        return simulation;
    }

    SimState state() {
        simulation();
        return state;
    }

    Course set(SimState replaced) {
        simulation();
        state = replaced;
        return this;
    }

    Vec3 feet() {
        return state().player().feet();
    }

    Course hold(PlayerInput input, double seconds) {
        return hold(input, seconds, ignored -> {});
    }

    /** Holds the input and passes the state after every tick to {@code look}. */
    Course hold(PlayerInput input, double seconds, Consumer<PlayerState> look) {
        simulation();
        long ticks = Math.round(seconds * settings.ticksPerSecond());
        for (long i = 0; i < ticks; i++) {
            state = simulation.step(state, input);
            look.accept(state.player());
        }
        return this;
    }
}
