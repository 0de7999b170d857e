package nephele.engine.sim;

import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Sweep;
import nephele.engine.math.Vec3;
import nephele.engine.sim.player.PlayerEye;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.FallState;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.PortalWorldCache;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickTrace;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Applies {@link Assist#SAFE_RETURN}: a player that has fallen below everything solid is put back, while the picture is
 * black, where it last stood on static ground.
 *
 * <p>Such a place is away from every open portal, as these may close; bodies are not ground, as they may be gone. It is
 * tested again on return, because the level may have been edited; the start takes its place then.
 */
final class SafeReturn {
    private static final Vector3dc STILL = new Vector3d();
    private static final Vector3dc ONTO_GROUND = new Vector3d(0, -2 * Sweep.SKIN_METRES, 0);

    private final CollisionWorld statics;
    private final PortalWorldCache worlds;
    private final PlayerState start;
    private final double lowest;
    private final long stoodTicks;
    private final long fadeTicks;
    private final Sweep sweep = new Sweep();
    private final Depenetration depenetration = new Depenetration();
    private final Vector3d centre = new Vector3d();

    /** @param start the player at the level's start */
    SafeReturn(CollisionWorld statics, PortalWorldCache worlds, PlayerState start, int ticksPerSecond) {
        this.statics = statics;
        this.worlds = worlds;
        this.start = start;
        lowest = statics.size() == 0
                ? Double.NEGATIVE_INFINITY
                : statics.extent().minY();
        stoodTicks = (long) Math.ceil(FallState.STOOD_SECONDS * ticksPerSecond);
        fadeTicks = (long) Math.floor(FallState.FADE_SECONDS * ticksPerSecond);
    }

    /**
     * Applies the assist after the player has moved.
     *
     * @param events receives an event when a fall begins and when it ends
     */
    SimState after(SimState walked, List<TickEvent> events) {
        FallState known = walked.world().fall();
        FallState fall = known == FallState.NONE ? FallState.start(start) : known;
        PlayerState player = walked.player();
        long tick = walked.tick();
        if (fall.isFalling()) {
            return tick - fall.fellTick() < fadeTicks ? walked : returned(walked, fall, events);
        }
        if (isBelowEverything(player)) {
            events.add(new TickEvent.PlayerFell());
            return walked.with(walked.world().with(fall.fell(tick)));
        }
        return walked.with(walked.world().with(stood(fall, walked)));
    }

    /** Nothing solid can stop a player whose crown is below the lowest point of the level. */
    private boolean isBelowEverything(PlayerState player) {
        return player.feet().y() + player.stance().heightMetres() < lowest
                && player.velocity().y() <= 0;
    }

    private SimState returned(SimState fallen, FallState fall, List<TickEvent> events) {
        PlayerState home = isFree(fall.safe()) && hasGround(fall.safe()) ? fall.safe() : start;
        boolean jumpHeld = fallen.player().jumpHeld();
        PlayerState back = new PlayerState(
                home.feet(), Vec3.ZERO, home.heading(), home.eyeMetres(), home.stance(), null, jumpHeld);
        events.add(new TickEvent.PlayerReturned());
        return fallen.withPlayer(back).with(fallen.world().with(TickTrace.NONE).with(fall.returned(fallen.tick())));
    }

    private FallState stood(FallState fall, SimState walked) {
        PlayerState player = walked.player();
        if (!player.isGrounded()) {
            return fall.candidate() == null ? fall : fall.withCandidate(null, 0);
        }
        boolean isDue = fall.candidate() != null && walked.tick() - fall.candidateTick() >= stoodTicks;
        FallState now = isDue ? fall.confirmed() : fall;
        return now.candidate() == null && isSafe(walked) ? now.withCandidate(atRest(player), walked.tick()) : now;
    }

    private boolean isSafe(SimState state) {
        PlayerState player = state.player();
        return player.tilt().isBodyUpright()
                && player.tilt().isViewLevel()
                && hasGround(player)
                && worlds.of(state.world().portals()).active(player.stance().shape(), centre, STILL) == 0
                && isFree(player);
    }

    private boolean hasGround(PlayerState player) {
        RoundedHull shape = player.stance().shape();
        return sweep.cast(statics, shape, PlayerEye.centre(player, centre), ONTO_GROUND)
                && Math.max(sweep.normal().y(), sweep.upmostNormal().y()) >= PlayerDimensions.MIN_GROUND_NORMAL_Y;
    }

    private boolean isFree(PlayerState player) {
        return depenetration.isFree(statics, player.stance().shape(), PlayerEye.centre(player, centre));
    }

    private static PlayerState atRest(PlayerState player) {
        double eye = player.stance().eyeMetres();
        return new PlayerState(player.feet(), Vec3.ZERO, player.heading(), eye, player.stance(), null, false);
    }
}
