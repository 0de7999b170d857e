package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.sim.carry.PlayerActions;
import nephele.engine.sim.player.PlayerPortalCrossing;
import nephele.engine.sim.player.PlayerStep;
import nephele.engine.sim.state.Action;
import nephele.engine.sim.state.Arrival;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.ExitState;
import nephele.engine.sim.state.FallState;
import nephele.engine.sim.state.FaultLog;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.PortalWorldCache;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickTrace;
import nephele.engine.sim.state.ViewAngles;
import nephele.engine.sim.state.WorldState;

/**
 * The simulation: maps a state and an input to the next state, without any other dependency. Allocates little more than
 * the state. Not thread-safe: the working set is reused.
 */
public final class Simulation {
    /** What is this far below all static geometry has left the world: the player starts again. */
    public static final double FALL_METRES = 50;

    private final SimSettings settings;
    private final SimState start;
    private final PlayerStep playerStep;
    private final PortalWorldCache worlds;
    private final BodiesTick bodiesTick;
    private final PlayerActions hands;
    private final EditContinuation continuation;
    private final Assists assists;
    private final int actionsOfHands;
    private final double lowest;
    /** {@code null} without bodies and without the assist. */
    private final BodyReturn bodyReturn;
    /** {@code null} without the assist. */
    private final SafeReturn safeReturn;

    private final List<Exit> exits;
    private final FaultLog faults;

    /** Creates the simulation of a level without models. */
    public Simulation(Level level, SimSettings settings) {
        this(SimLevel.of(level), settings, FaultLog.SILENT);
    }

    /** @param start where the player starts, {@code null} for the origin */
    public Simulation(CollisionWorld world, PlayerStart start, SimSettings settings, FaultLog faults) {
        this(SimLevel.of(world, start), settings, faults);
    }

    /** @param faults receives a message for each fault of a tick */
    public Simulation(SimLevel level, SimSettings settings, FaultLog faults) {
        this.settings = settings;
        this.faults = faults;
        exits = level.exits();
        var statics = level.statics();
        double seconds = 1.0 / settings.ticksPerSecond();
        worlds = new PortalWorldCache(statics);
        PlayerState standing = standing(level.start());
        boolean returnsPlayer = settings.assists().contains(Assist.SAFE_RETURN);
        Arrival arrival = settings.assists().contains(Assist.EXIT_ROOM) ? Arrival.NOWHERE : Arrival.NONE;
        FallState fall = returnsPlayer ? FallState.start(standing) : FallState.NONE;
        start = new SimState(0, 1, 0, standing, level.begin(worlds).with(fall).with(arrival));
        safeReturn = returnsPlayer ? new SafeReturn(statics, worlds, standing, settings.ticksPerSecond()) : null;
        playerStep = new PlayerStep(level.bodies(), settings);
        bodiesTick = new BodiesTick(level.bodies(), worlds, seconds, faults);
        assists = new Assists(settings);
        hands = new PlayerActions(level, worlds, settings);
        continuation = new EditContinuation(level, worlds);
        actionsOfHands = level.gun() == null && level.bodies().size() == 0 ? 0 : Action.HAND_ACTIONS;
        lowest = statics.size() == 0
                ? Double.NEGATIVE_INFINITY
                : statics.extent().minY() - FALL_METRES;
        boolean returnsBodies = level.bodies().size() > 0 && settings.assists().contains(Assist.BODY_RETURN);
        bodyReturn = returnsBodies ? new BodyReturn(level.bodies(), worlds, lowest) : null;
    }

    private static PlayerState standing(PlayerStart start) {
        return PlayerState.standing(start.feet(), ViewAngles.ofDegrees(start.yawDegrees(), start.pitchDegrees()));
    }

    /** Returns the settings. */
    public SimSettings settings() {
        return settings;
    }

    /** Returns the state at tick 0. */
    public SimState start() {
        return start;
    }

    /** Returns the state at tick 0 with the player elsewhere. */
    public SimState startFrom(PlayerStart elsewhere) {
        return start.withPlayer(standing(elsewhere));
    }

    /**
     * Returns a state of this simulation as the game continues in an edited level. Shot portals close if their surface
     * is gone or no longer accepts portals; occupants of these move to their centre's side.
     *
     * @return {@code null} if an occupant finds no room: the edit has to wait
     * @throws IllegalArgumentException if the edited level has a different number of bodies
     */
    public SimState continuedIn(Simulation edited, SimState state) {
        return edited.continuation.of(state, worlds.of(state.world().portals()));
    }

    /** Returns what a shot would do in a state, for the portal preview; {@code null} in a level without a gun. */
    public PlacementResult aim(SimState state, GunPortals.Colour shot) {
        return hands.aim(state, shot);
    }

    /** Returns true if the player of a state would pick up a body. */
    public boolean canPickUp(SimState state) {
        return hands.canPickUp(state);
    }

    /**
     * Returns the state one tick later. The stages are:
     *
     * <ol>
     *   <li>the hands: shots change the portals, a body is picked up, dropped or thrown;
     *   <li>the player looks, walks or flies; with the assist one that has fallen out of the level returns;
     *   <li>the held body is driven, and all bodies move; with the assist those that have left the world return;
     *   <li>the line to the held body is updated, or breaks;
     *   <li>the level ends if the player is in an exit for the first time.
     * </ol>
     */
    public SimState step(SimState before, PlayerInput input) {
        boolean hasEvents = actionsOfHands != 0 || !exits.isEmpty() || safeReturn != null;
        List<TickEvent> events = hasEvents ? new ArrayList<>(0) : List.of();
        SimState acted = actionsOfHands == 0 ? before : hands.act(before, input, events);
        SimState free = movePlayer(acted, input);
        SimState walked = safeReturn == null ? free : safeReturn.after(free, events);
        SimState moved = assists.limited(bodiesTick.step(walked, playerStep.pushes(), hands.drive(acted, input)));
        SimState kept = bodyReturn == null ? moved : bodyReturn.after(moved, events);
        CrossingWord crossed = walked.world().trace().playerCrossed();
        SimState followed = hands.follow(kept, crossed, events);
        ExitState exit = exit(followed, events);
        TickTrace trace = TickTrace.of(input.actions() & actionsOfHands, crossed, events);
        return followed.with(followed.world().with(trace).with(exit));
    }

    private ExitState exit(SimState state, List<TickEvent> events) {
        ExitState before = state.world().exit();
        ExitState now = before.after(state.tick(), state.player().centre(), exits);
        if (now != before) {
            events.add(new TickEvent.ExitReached(now.exit()));
        }
        return now;
    }

    /** Moves the player. A tick with a result that is not finite is undone and leaves the player at rest. */
    private SimState movePlayer(SimState before, PlayerInput input) {
        Portals portals = before.world().portals();
        PortalWorld world = worlds.of(portals);
        PlayerState led = assists.before(before.player(), input, portals);
        PlayerState after = led.isFinite() ? playerStep.step(world, before.world(), led, input) : null;
        if (after == null || !after.isFinite()) {
            faults.fault(before.tick(), "the player's state is not finite: " + before.player());
            return next(before, before.faults() + 1, stopped(before.player()), CrossingWord.EMPTY);
        }
        if (safeReturn == null && after.feet().y() < lowest) {
            return next(before, before.faults(), start.player(), CrossingWord.EMPTY);
        }
        int dropped = playerStep.hasDroppedTime() ? 1 : 0;
        if (dropped > 0) {
            faults.fault(
                    before.tick(),
                    "more than " + PlayerPortalCrossing.MOST_HOPS + " portals in a tick: the rest of it is dropped");
        }
        PlayerState helped = assists.after(after, playerStep.crossed(), portals);
        SimState next = next(before, before.faults() + dropped, helped, playerStep.crossed());
        return next.with(next.world().with(arrival(next.world())));
    }

    private Arrival arrival(WorldState around) {
        CrossingWord crossed = around.trace().playerCrossed();
        if (around.arrival() == Arrival.NONE || crossed.length() == 0) {
            return around.arrival().later();
        }
        return Arrival.at(around.portals().partner(crossed.entry(crossed.length() - 1)), settings.ticksPerSecond());
    }

    private static SimState next(SimState before, int faults, PlayerState player, CrossingWord crossed) {
        WorldState around = before.world().with(TickTrace.of(0, crossed, List.of()));
        return new SimState(before.tick() + 1, before.random(), faults, player, around);
    }

    private PlayerState stopped(PlayerState broken) {
        PlayerState still = broken.withVelocity(Vec3.ZERO);
        return still.isFinite() ? still : start.player();
    }
}
