package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.sim.carry.PlayerActions;
import nephele.engine.sim.player.BodyPushes;
import nephele.engine.sim.player.PlayerStep;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.ViewAngles;
import nephele.engine.sim.state.WorldState;
import nephele.engine.sim.state.WorldState.Arrival;
import nephele.engine.sim.state.WorldState.ExitState;
import nephele.engine.sim.state.WorldState.FallState;
import nephele.engine.sim.state.WorldState.HeldBody;
import nephele.engine.sim.state.WorldState.TickTrace;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The simulation: maps a state and an input to the next state, without any other dependency. Allocates little more than
 * the state. Not thread-safe: the working set is reused.
 */
public final class Simulation {
    /** The distance below all static geometry at which something has left the world: a player starts again. */
    public static final double FALL_METRES = 50;

    /** The speed in m/s above which a player that is pushed upwards leaves the ground. */
    private static final double LIFTING_METRES_PER_SECOND = 0.5;

    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private final SimSettings settings;
    private final SimState start;
    private final PlayerStep playerStep;
    private final PortalWorld.Cache worlds;
    /** {@code null} without bodies. */
    private final RigidStep rigidStep;

    private final BodyInfluences influences = new BodyInfluences();
    private final BodyInfluences.Character standing = character(PlayerDimensions.Stance.STANDING);
    private final BodyInfluences.Character crouched = character(PlayerDimensions.Stance.CROUCHED);
    private final Vector3d centre = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final PlayerActions hands;
    private final Assists assists;
    private final int actionsOfHands;
    private final boolean returnsPlayer;
    private final double lowest;
    private final FallReturn fallReturn;
    private final List<Exit> exits;
    private final double seconds;

    /** Creates the simulation of a level without models. */
    public Simulation(Level level, SimSettings settings) {
        this(SimLevel.of(level), settings);
    }

    /** @param start where the player starts, {@code null} for the origin */
    public Simulation(CollisionWorld world, PlayerStart start, SimSettings settings) {
        this(SimLevel.of(world, start), settings);
    }

    /** Creates the simulation of a level. */
    public Simulation(SimLevel level, SimSettings settings) {
        this.settings = settings;
        exits = level.exits();
        var statics = level.statics();
        seconds = 1.0 / settings.ticksPerSecond();
        worlds = new PortalWorld.Cache(statics);
        PlayerState standing = standing(level.start());
        returnsPlayer = settings.assists().contains(Assist.SAFE_RETURN);
        Arrival arrival = settings.assists().contains(Assist.EXIT_ROOM) ? Arrival.NOWHERE : Arrival.NONE;
        FallState fall = returnsPlayer ? FallState.start(standing) : FallState.NONE;
        start = new SimState(0, 1, 0, standing, level.begin(worlds).with(fall).with(arrival));
        playerStep = new PlayerStep(level.bodies(), settings);
        rigidStep = level.bodies().size() == 0 ? null : new RigidStep(level.bodies(), GRAVITY);
        assists = new Assists(settings);
        hands = new PlayerActions(level, worlds, settings);
        actionsOfHands = level.gun() == null && level.bodies().size() == 0 ? 0 : Action.HAND_ACTIONS;
        lowest = statics.size() == 0
                ? Double.NEGATIVE_INFINITY
                : statics.extent().minY() - FALL_METRES;
        fallReturn = new FallReturn(level, worlds, standing, settings);
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
        boolean hasEvents = actionsOfHands != 0 || !exits.isEmpty() || returnsPlayer;
        List<TickEvent> events = hasEvents ? new ArrayList<>(0) : List.of();
        SimState acted = actionsOfHands == 0 ? before : hands.act(before, input, events);
        SimState free = movePlayer(acted, input);
        SimState walked = fallReturn.afterPlayer(free, events);
        SimState moved = assists.limited(moveBodies(walked, playerStep.pushes(), hands.drive(acted, input)));
        SimState kept = fallReturn.afterBodies(moved, events);
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
            return next(before, before.faults() + 1, stopped(before.player()), CrossingWord.EMPTY);
        }
        if (!returnsPlayer && after.feet().y() < lowest) {
            return next(before, before.faults(), start.player(), CrossingWord.EMPTY);
        }
        int dropped = playerStep.hasDroppedTime() ? 1 : 0;
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

    /**
     * Steps all bodies by one tick: they collide with the player's capsule and each other, and the held body is driven.
     *
     * @param walked the state in which the player has moved and the bodies have not
     * @param pushes the player's contacts with bodies, and its push on them
     * @param drive the motion of the held body, {@code null} for none
     */
    private SimState moveBodies(SimState walked, BodyPushes pushes, BodyState drive) {
        if (rigidStep == null) {
            return walked;
        }
        WorldState around = walked.world();
        influences.clearDriven();
        influences.clearPassing();
        if (around.holding().passing() != HeldBody.NONE) {
            influences.ignoreCharacters(around.holding().passing());
        }
        if (drive != null) {
            influences.drive(around.holding().body(), drive.velocity(), drive.spin());
        }
        BodyInfluences.Character player = placeCharacter(walked.player(), pushes);
        Bodies moved = rigidStep.step(around.bodies(), worlds.of(around.portals()), influences, seconds);
        int faulty = moved.frozen() - around.bodies().frozen() + rigidStep.cutShort();
        return walked.withPlayer(shoved(walked.player(), player.impulse(), pushes.push()))
                .withFaults(walked.faults() + Math.max(0, faulty))
                .with(around.with(moved));
    }

    /**
     * Adds the velocity change that the bodies gave the player. The player's own push is taken out of it, as the ground
     * bears its reaction.
     */
    private PlayerState shoved(PlayerState player, Vector3dc impulse, Vector3dc push) {
        if (impulse.lengthSquared() == 0) {
            return player;
        }
        impulse.div(PlayerDimensions.MASS_KILOGRAMS, velocity).add(push);
        boolean stays = player.isGrounded() && velocity.y < LIFTING_METRES_PER_SECOND;
        Vec3 own = player.velocity();
        return player.shoved(
                new Vec3(own.x() + velocity.x, own.y() + (stays ? 0 : velocity.y), own.z() + velocity.z), stays);
    }

    /**
     * Sets the player's capsule for the step. Without contacts it starts where the player's tick began, so that both
     * move at the same time; in contact it starts where the player is and pushes from there.
     */
    private BodyInfluences.Character placeCharacter(PlayerState player, BodyPushes pushes) {
        influences.clearCharacters();
        BodyInfluences.Character body = player.stance() == PlayerDimensions.Stance.STANDING ? standing : crouched;
        influences.add(body);
        Vec3 own = player.velocity();
        velocity.set(own.x(), own.y(), own.z());
        player.centre(centre).fma(pushes.isTouching() ? 0 : -seconds, velocity);
        body.move(centre, velocity.add(pushes.push()));
        return body;
    }

    /**
     * Returns the player's capsule, enlarged by the skin that its own sweeps keep from obstacles, so that it touches
     * bodies there.
     */
    private static BodyInfluences.Character character(PlayerDimensions.Stance stance) {
        double skin = Sweep.SKIN_METRES;
        return new BodyInfluences.Character(
                PlayerDimensions.RADIUS_METRES + skin,
                stance.heightMetres() + 2 * skin,
                PlayerDimensions.MASS_KILOGRAMS);
    }
}
