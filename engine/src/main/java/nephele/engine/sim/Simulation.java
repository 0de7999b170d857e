package nephele.engine.sim;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;

/**
 * The rules: a state and an input give the next state, and nothing else matters. Allocates little more than the state.
 * Not for two threads at once: the working set is reused.
 */
public final class Simulation {
    /** A player this far below everything solid begins again. */
    private static final double FALL_METRES = 50;

    private final SimSettings settings;
    private final SimState start;
    private final PlayerStep playerStep;
    private final CollisionWorld statics;
    private SeamedWorld seamed;
    private Portals seamedFor;
    private final double lowest;
    private final FaultLog faults;

    public Simulation(Level level, SimSettings settings) {
        this(SimLevel.of(level), settings, FaultLog.SILENT);
    }

    /** @param start where the player begins, {@code null}: at the origin */
    public Simulation(CollisionWorld world, PlayerStart start, SimSettings settings, FaultLog faults) {
        this(SimLevel.of(world, start), settings, faults);
    }

    public Simulation(SimLevel level, SimSettings settings, FaultLog faults) {
        this.settings = settings;
        this.faults = faults;
        var statics = level.statics();
        Changeable around = level.portals().size() == 0
                ? Changeable.NOTHING
                : new Changeable(level.portals(), Shots.NONE, Holding.NOTHING, TickTrace.NONE);
        start = new SimState(0, 1, 0, standing(level.start()), around);
        playerStep = new PlayerStep(1.0 / settings.ticksPerSecond());
        this.statics = statics;
        lowest = statics.size() == 0
                ? Double.NEGATIVE_INFINITY
                : statics.extent().minY() - FALL_METRES;
    }

    private static PlayerState standing(PlayerStart start) {
        return PlayerState.standing(start.feet(), Heading.ofDegrees(start.yawDegrees(), start.pitchDegrees()));
    }

    public SimSettings settings() {
        return settings;
    }

    /** The state at tick 0. */
    public SimState start() {
        return start;
    }

    /** The state at tick 0 with the player elsewhere. */
    public SimState startFrom(PlayerStart elsewhere) {
        return start.withPlayer(standing(elsewhere));
    }

    /** The state one tick later. A tick that would give numbers that are not finite leaves the player standing still. */
    public SimState step(SimState before, PlayerInput input) {
        SeamedWorld world = seamed(before.around().portals());
        PlayerState after = before.player().isFinite() ? playerStep.step(world, before.player(), input) : null;
        if (after == null || !after.isFinite()) {
            faults.fault(before.tick(), "the player's state is not finite: " + before.player());
            return next(before, before.faults() + 1, stopped(before.player()));
        }
        int dropped = playerStep.hasDroppedTime() ? 1 : 0;
        if (dropped > 0) {
            faults.fault(
                    before.tick(), "more than " + Passing.MOST_HOPS + " portals in a tick: the rest of it is dropped");
        }
        return next(before, before.faults() + dropped, after.feet().y() < lowest ? start.player() : after);
    }

    /** Portals change by shots alone, and then all of them: the last set's world is kept. */
    private SeamedWorld seamed(Portals portals) {
        if (seamedFor != portals) {
            seamedFor = portals;
            seamed = SeamedWorld.of(statics, portals);
        }
        return seamed;
    }

    private static SimState next(SimState before, int faults, PlayerState player) {
        return new SimState(before.tick() + 1, before.random(), faults, player, before.around());
    }

    private PlayerState stopped(PlayerState broken) {
        PlayerState still = broken.withVelocity(Vec3.ZERO);
        return still.isFinite() ? still : start.player();
    }
}
