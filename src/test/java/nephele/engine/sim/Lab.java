package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState.HeldBody;

/** A {@link RoomLevel} and the player in it. The floor's top is at y = 0. */
public final class Lab {
    private final RoomLevel room;
    private SimSettings settings = SimSettings.DEFAULT;
    private final List<TickEvent> events = new ArrayList<>();
    private Simulation simulation;
    private SimState state;

    Lab() {
        this(new RoomLevel());
    }

    private Lab(RoomLevel room) {
        this.room = room;
    }

    /** Returns the room of {@link RoomLevel#hall}. */
    public static Lab hall() {
        return new Lab(RoomLevel.hall());
    }

    /**
     * Returns a hall with the first portal in the wall ahead and the second in the wall to the left, both down to the
     * floor, and a cube aside.
     */
    public static Lab twoPortals(double cubeEdge) {
        return hall().gun()
                .cube(new Vec3(3, cubeEdge / 2, 3), cubeEdge, 10)
                .startAt(0, 0, 0, 0, -5)
                .press(Action.FIRE_FIRST)
                .turn(90, 0)
                .press(Action.FIRE_SECOND);
    }

    /** Adds a box by its lower and upper corner. */
    public Lab box(double x0, double y0, double z0, double x1, double y1, double z1) {
        return box(x0, y0, z0, x1, y1, z1, true);
    }

    Lab box(double x0, double y0, double z0, double x1, double y1, double z1, boolean portalable) {
        room.box(x0, y0, z0, x1, y1, z1, portalable);
        return this;
    }

    public Lab gun() {
        room.gun();
        return this;
    }

    /** Adds two linked fixed portals of 1.2 m × 2.1 m. */
    public Lab pair(Vec3 centreA, Vec3 normalA, Vec3 centreB, Vec3 normalB) {
        room.pair(centreA, normalA, centreB, normalB);
        return this;
    }

    public Lab cube(Vec3 centre, double edge, double kilograms) {
        room.cube(centre, edge, kilograms);
        return this;
    }

    Lab body(Body body) {
        room.body(body);
        return this;
    }

    public Lab startAt(double x, double y, double z, double yawDegrees, double pitchDegrees) {
        room.startAt(x, y, z, yawDegrees, pitchDegrees);
        return this;
    }

    public Lab with(SimSettings changed) {
        settings = changed;
        return this;
    }

    public Level level() {
        return room.level();
    }

    Simulation simulation() {
        if (simulation == null) {
            simulation = new Simulation(level(), settings);
            state = simulation.start();
        }
        return simulation;
    }

    public SimState state() {
        simulation();
        return state;
    }

    public Lab set(SimState replaced) {
        simulation();
        state = replaced;
        return this;
    }

    public PlayerState player() {
        return state().player();
    }

    public HeldBody holding() {
        return state().world().holding();
    }

    public Vec3 body(int body) {
        return state().world().bodies().state(body).centre();
    }

    /** Returns all events so far. */
    public List<TickEvent> events() {
        return events;
    }

    public Lab tick(PlayerInput input) {
        state = simulation().step(state(), input);
        events.addAll(state.world().trace().events());
        return this;
    }

    public Lab hold(PlayerInput input, double seconds) {
        return hold(input, seconds, ignored -> {});
    }

    public Lab hold(PlayerInput input, double seconds, Consumer<SimState> look) {
        long ticks = Math.round(seconds * settings.ticksPerSecond());
        for (long i = 0; i < ticks; i++) {
            tick(input);
            look.accept(state);
        }
        return this;
    }

    /** Presses an action for one tick and releases it. */
    public Lab press(Action action) {
        return tick(PlayerInput.NONE.holding(action)).tick(PlayerInput.NONE);
    }

    /** Turns within one tick. */
    public Lab turn(double leftDegrees, double upDegrees) {
        return tick(PlayerInput.NONE.turning((int) Math.round(1000 * leftDegrees), (int) Math.round(1000 * upDegrees)));
    }
}
