package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/** A level with portals, a gun and bodies, built by the test, and the player in it. The floor's top is at y = 0. */
final class Lab {
    private final List<Solid> solids = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private PlayerStart start = new PlayerStart(Vec3.ZERO, 0, 0);
    private PortalGun gun;
    private SimSettings settings = SimSettings.DEFAULT;
    private final List<TickEvent> told = new ArrayList<>();
    private Simulation simulation;
    private SimState state;

    /** A hall of 16 m by 16 m, 6 m high, all of it portalable: z = −8 is the wall ahead, x = −8 the one to the left. */
    static Lab hall() {
        return new Lab()
                .box(-8, -1, -8, 8, 0, 8)
                .box(-8, 6, -8, 8, 7, 8)
                .box(-9, -1, -9, -8, 7, 9)
                .box(8, -1, -9, 9, 7, 9)
                .box(-9, -1, -9, 9, 7, -8)
                .box(-9, -1, 8, 9, 7, 9);
    }

    /** The first portal in the wall ahead, the second in the wall to the left, both down to the floor; a cube aside. */
    static Lab twoPortals(double cubeEdge) {
        return hall().gun()
                .cube(new Vec3(3, cubeEdge / 2, 3), cubeEdge, 10)
                .startAt(0, 0, 0, 0, -5)
                .press(Action.FIRE_FIRST)
                .turn(90, 0)
                .press(Action.FIRE_SECOND);
    }

    /** By its lower and upper corner. */
    Lab box(double x0, double y0, double z0, double x1, double y1, double z1) {
        return box(x0, y0, z0, x1, y1, z1, true);
    }

    Lab box(double x0, double y0, double z0, double x1, double y1, double z1, boolean portalable) {
        Vec3 centre = new Vec3((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
        Vec3 size = new Vec3(x1 - x0, y1 - y0, z1 - z0);
        solids.add(new Solid.Box("box" + solids.size(), null, portalable, null, centre, size, Map.of()));
        return this;
    }

    Lab gun() {
        gun = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);
        return this;
    }

    /** Two fixed ones of 1.2 m × 2.1 m that lead to each other. */
    Lab pair(Vec3 centreA, Vec3 normalA, Vec3 centreB, Vec3 normalB) {
        String a = "p" + portals.size();
        String b = "p" + (portals.size() + 1);
        portals.add(portal(a, b, centreA, normalA));
        portals.add(portal(b, a, centreB, normalB));
        return this;
    }

    private static PortalSpec portal(String id, String linkedTo, Vec3 centre, Vec3 normal) {
        Vec3 up = Math.abs(normal.y()) > 0.9 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        return new PortalSpec(id, linkedTo, centre, normal, up, 1.2, 2.1, PortalShape.ARCH);
    }

    Lab cube(Vec3 centre, double edge, double kilograms) {
        Vec3 size = new Vec3(edge, edge, edge);
        bodies.add(new Body.Box("cube" + bodies.size(), centre, size, kilograms, null, 0.6, 0));
        return this;
    }

    Lab body(Body body) {
        bodies.add(body);
        return this;
    }

    Lab startAt(double x, double y, double z, double yawDegrees, double pitchDegrees) {
        start = new PlayerStart(new Vec3(x, y, z), yawDegrees, pitchDegrees);
        return this;
    }

    Lab with(SimSettings changed) {
        settings = changed;
        return this;
    }

    Level level() {
        var environment = new Environment(null, null, null, 0, ToneCurve.CLIP, null, List.of());
        return new Level(
                "lab",
                "",
                environment,
                start,
                List.of(),
                List.of(),
                List.copyOf(solids),
                List.of(),
                List.copyOf(portals),
                List.of(),
                List.copyOf(bodies),
                gun);
    }

    Simulation simulation() {
        if (simulation == null) {
            simulation = new Simulation(level(), settings);
            state = simulation.start();
        }
        return simulation;
    }

    SimState state() {
        simulation();
        return state;
    }

    Lab set(SimState replaced) {
        simulation();
        state = replaced;
        return this;
    }

    PlayerState player() {
        return state().player();
    }

    Holding holding() {
        return state().around().holding();
    }

    Vec3 body(int body) {
        return state().around().bodies().state(body).centre();
    }

    /** Everything that happened so far. */
    List<TickEvent> told() {
        return told;
    }

    Lab tick(PlayerInput input) {
        state = simulation().step(state(), input);
        told.addAll(state.around().trace().events());
        return this;
    }

    Lab hold(PlayerInput input, double seconds) {
        return hold(input, seconds, ignored -> {});
    }

    Lab hold(PlayerInput input, double seconds, Consumer<SimState> look) {
        long ticks = Math.round(seconds * settings.ticksPerSecond());
        for (long i = 0; i < ticks; i++) {
            tick(input);
            look.accept(state);
        }
        return this;
    }

    /** Presses and lets go. */
    Lab press(Action action) {
        return tick(PlayerInput.NONE.holding(action)).tick(PlayerInput.NONE);
    }

    /** Turns at once. */
    Lab turn(double leftDegrees, double upDegrees) {
        return tick(PlayerInput.NONE.turning((int) Math.round(1000 * leftDegrees), (int) Math.round(1000 * upDegrees)));
    }
}
