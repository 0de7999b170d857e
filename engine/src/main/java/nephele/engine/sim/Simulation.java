package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Placed;

/**
 * The simulation: maps a state and an input to the next state, without any other dependency. Allocates little more than
 * the state. Not thread-safe: the working set is reused.
 */
public final class Simulation {
    /** A player this far below all static geometry starts again. */
    private static final double FALL_METRES = 50;

    private final SimSettings settings;
    private final SimState start;
    private final PlayerStep playerStep;
    private final Spaces spaces;
    private final BodiesTick bodiesTick;
    private final Hands hands;
    private final Continuation continuation;
    private final Assists assists;
    private final int actionsOfHands;
    private final double lowest;
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
        var statics = level.statics();
        double seconds = 1.0 / settings.ticksPerSecond();
        spaces = new Spaces(statics);
        start = new SimState(0, 1, 0, standing(level.start()), level.begin(spaces));
        playerStep = new PlayerStep(level.bodies(), settings);
        bodiesTick = new BodiesTick(level.bodies(), spaces, seconds, faults);
        assists = new Assists(settings);
        hands = new Hands(level, spaces, seconds);
        continuation = new Continuation(level, spaces);
        actionsOfHands = level.gun() == null && level.bodies().size() == 0 ? 0 : Action.OF_HANDS;
        lowest = statics.size() == 0
                ? Double.NEGATIVE_INFINITY
                : statics.extent().minY() - FALL_METRES;
    }

    private static PlayerState standing(PlayerStart start) {
        return PlayerState.standing(start.feet(), Heading.ofDegrees(start.yawDegrees(), start.pitchDegrees()));
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
        return edited.continuation.of(state, spaces.of(state.around().portals()));
    }

    /** Returns what a shot would do in a state, for the portal preview; {@code null} in a level without a gun. */
    public Placed aim(SimState state, Shots.Colour shot) {
        return hands.aim(state, shot);
    }

    /**
     * Returns the state one tick later. The stages are:
     *
     * <ol>
     *   <li>the hands: shots change the portals, a body is picked up, dropped or thrown;
     *   <li>the player looks, walks or flies;
     *   <li>the held body is driven, and all bodies move;
     *   <li>the line to the held body is updated, or breaks.
     * </ol>
     */
    public SimState step(SimState before, PlayerInput input) {
        List<TickEvent> events = actionsOfHands == 0 ? List.of() : new ArrayList<>(0);
        SimState acted = actionsOfHands == 0 ? before : hands.act(before, input, events);
        SimState walked = movePlayer(acted, input);
        SimState moved = assists.limited(bodiesTick.step(walked, playerStep.shoves(), hands.drive(acted, input)));
        CrossingWord crossed = walked.around().trace().playerCrossed();
        SimState followed = hands.follow(moved, crossed, events);
        TickTrace trace = TickTrace.of(input.actions() & actionsOfHands, crossed, events);
        return followed.with(followed.around().with(trace));
    }

    /** Moves the player. A tick with a result that is not finite is undone and leaves the player at rest. */
    private SimState movePlayer(SimState before, PlayerInput input) {
        Portals portals = before.around().portals();
        SeamedWorld world = spaces.of(portals);
        PlayerState led = assists.before(before.player(), input, portals);
        PlayerState after = led.isFinite() ? playerStep.step(world, before.around(), led, input) : null;
        if (after == null || !after.isFinite()) {
            faults.fault(before.tick(), "the player's state is not finite: " + before.player());
            return next(before, before.faults() + 1, stopped(before.player()), CrossingWord.EMPTY);
        }
        if (after.feet().y() < lowest) {
            return next(before, before.faults(), start.player(), CrossingWord.EMPTY);
        }
        int dropped = playerStep.hasDroppedTime() ? 1 : 0;
        if (dropped > 0) {
            faults.fault(
                    before.tick(), "more than " + Passing.MOST_HOPS + " portals in a tick: the rest of it is dropped");
        }
        PlayerState helped = assists.after(after, playerStep.crossed(), portals);
        return next(before, before.faults() + dropped, helped, playerStep.crossed());
    }

    private static SimState next(SimState before, int faults, PlayerState player, CrossingWord crossed) {
        Changeable around = before.around().with(TickTrace.of(0, crossed, List.of()));
        return new SimState(before.tick() + 1, before.random(), faults, player, around);
    }

    private PlayerState stopped(PlayerState broken) {
        PlayerState still = broken.withVelocity(Vec3.ZERO);
        return still.isFinite() ? still : start.player();
    }
}
