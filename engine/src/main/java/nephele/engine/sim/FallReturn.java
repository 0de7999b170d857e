package nephele.engine.sim;

import java.util.List;
import java.util.function.Function;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.sim.carry.PortalOccupants;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState.FallState;
import nephele.engine.sim.state.WorldState.TickTrace;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Puts back what has fallen out of the world, where the assists ask for it.
 *
 * <p>{@link Assist#SAFE_RETURN}: a player that has fallen below everything solid is put back, while the picture is
 * black, where it last stood on static ground. Such a place is away from every open portal, as these may close; bodies
 * are not ground, as they may be gone. It is tested again on return, because the level may have been edited; the start
 * takes its place then.
 *
 * <p>{@link Assist#BODY_RETURN}: a body is put back at rest where the level has it, as soon as that place is free. It
 * keeps falling as long as the player or another body is in its place, also with a part that reaches there through a
 * portal. A held body stays with the player.
 */
final class FallReturn {
    private static final Vector3dc ONTO_GROUND = new Vector3d(0, -2 * Sweep.SKIN_METRES, 0);

    private final boolean returnsPlayer;
    private final boolean returnsBodies;
    private final CollisionWorld statics;
    private final BodyTable table;
    private final PortalWorld.Cache worlds;
    private final PlayerState start;
    /** Height of the lowest point of the level. */
    private final double lowest;

    private final long stoodTicks;
    private final long fadeTicks;
    private final Sweep sweep = new Sweep();
    private final Depenetration depenetration = new Depenetration();
    private final Separation separation = new Separation();
    private final Vector3d centre = new Vector3d();

    /** The place of a body in the level, its world, and the portals into which the body would reach there. */
    private Collider home;

    private PortalWorld world;
    private long active;

    /** @param start the player at the level's start */
    FallReturn(SimLevel level, PortalWorld.Cache worlds, PlayerState start, SimSettings settings) {
        returnsPlayer = settings.assists().contains(Assist.SAFE_RETURN);
        returnsBodies = settings.assists().contains(Assist.BODY_RETURN);
        statics = level.statics();
        table = level.bodies();
        this.worlds = worlds;
        this.start = start;
        lowest = statics.size() == 0
                ? Double.NEGATIVE_INFINITY
                : statics.extent().minY();
        stoodTicks = (long) Math.ceil(FallState.STOOD_SECONDS * settings.ticksPerSecond());
        fadeTicks = (long) Math.floor(FallState.FADE_SECONDS * settings.ticksPerSecond());
    }

    /**
     * Returns the state after the player has moved, with the player put back if it is due.
     *
     * @param events receives an event when a fall begins and when it ends
     */
    SimState afterPlayer(SimState walked, List<TickEvent> events) {
        if (!returnsPlayer) {
            return walked;
        }
        FallState known = walked.world().fall();
        FallState fall = known == FallState.NONE ? FallState.start(start) : known;
        PlayerState player = walked.player();
        long tick = walked.tick();
        if (fall.isFalling()) {
            return tick - fall.fellTick() < fadeTicks ? walked : returned(walked, fall, events);
        }
        if (isBelowEverything(player)) {
            events.add(TickEvent.Plain.PLAYER_FELL);
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
        events.add(TickEvent.Plain.PLAYER_RETURNED);
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
                && worlds.of(state.world().portals()).active(player.stance().shape(), centre) == 0
                && isFree(player);
    }

    private boolean hasGround(PlayerState player) {
        RoundedHull shape = player.stance().shape();
        return sweep.cast(statics, shape, player.centre(centre), ONTO_GROUND)
                && Math.max(sweep.normal().y(), sweep.upmostNormal().y()) >= PlayerDimensions.MIN_GROUND_NORMAL_Y;
    }

    private boolean isFree(PlayerState player) {
        return depenetration.isFree(statics, player.stance().shape(), player.centre(centre));
    }

    private static PlayerState atRest(PlayerState player) {
        double eye = player.stance().eyeMetres();
        return new PlayerState(player.feet(), Vec3.ZERO, player.heading(), eye, player.stance(), null, false);
    }

    /**
     * Returns the state after the bodies have moved, with the bodies put back whose places are free.
     *
     * @param events receives an event for each body that returns
     */
    SimState afterBodies(SimState moved, List<TickEvent> events) {
        SimState state = moved;
        for (int body = 0; returnsBodies && body < table.size(); body++) {
            if (isLost(state, body) && isHomeFree(state, body)) {
                Bodies bodies = state.world().bodies();
                BodyState home = BodyState.resting(table.body(body).centre());
                state = state.with(state.world().with(bodies.with(body, home)));
                events.add(new TickEvent.BodyReturned(body));
            }
        }
        return state;
    }

    private boolean isLost(SimState state, int body) {
        Bodies bodies = state.world().bodies();
        return bodies.centre(body, centre).y < lowest - Simulation.FALL_METRES
                && state.world().holding().body() != body
                && !bodies.isFrozen(body);
    }

    private boolean isHomeFree(SimState state, int body) {
        Vector3d at = table.body(body).centre().toVector();
        home = table.collider(body, at, new Quaterniond());
        world = worlds.of(state.world().portals());
        active = world.active(table.uprightHull(body), at);
        if (isHome(state.player())) {
            return false;
        }
        Bodies bodies = state.world().bodies();
        for (int other = 0; other < bodies.size(); other++) {
            if (other != body && isHome(bodies, other)) {
                return false;
            }
        }
        return true;
    }

    /** Returns true if something active on these portals may reach the place through a portal. */
    private boolean isBeyond(int entry, long others) {
        Portals portals = world.portals();
        boolean hasBit = entry < PortalWorld.MOST_PORTALS && portals.partner(entry) < PortalWorld.MOST_PORTALS;
        return hasBit && portals.isOpen(entry) && (others & 1L << entry | active & 1L << portals.partner(entry)) != 0;
    }

    private boolean isHome(PlayerState player) {
        Vec3 up = player.tilt().up();
        RoundedHull shape = player.stance().shape(up);
        return isHome(player.centre(new Vector3d()), shape, transform -> {
            Vec3 turned = Vec3.of(transform.direction(up.toVector()));
            return player.stance().shape(turned);
        });
    }

    private boolean isHome(Bodies bodies, int other) {
        Quaterniond turn = bodies.orientation(other, new Quaterniond());
        RoundedHull shape = table.hull(other, turn);
        return isHome(bodies.centre(other, new Vector3d()), shape, transform -> {
            Quaterniond turned = transform.orientation(new Quaterniond(turn));
            return table.hull(other, turned);
        });
    }

    /**
     * Returns true if a shape is in the place, or reaches there through a portal.
     *
     * @param turned the shape as a portal's transform turns it
     */
    private boolean isHome(Vector3dc at, RoundedHull shape, Function<PortalTransform, RoundedHull> turned) {
        centre.set(at);
        if (isHome(shape)) {
            return true;
        }
        Portals portals = world.portals();
        long others = world.active(shape, at);
        for (int entry = 0; entry < portals.size(); entry++) {
            if (isBeyond(entry, others)) {
                PortalTransform transform = portals.transform(entry);
                transform.point(centre.set(at));
                if (isHome(turned.apply(transform))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Returns true if a shape at {@link #centre} is in the place. */
    private boolean isHome(RoundedHull shape) {
        separation.measure(shape, centre.x, centre.y, centre.z, home);
        return separation.metres() < -PortalOccupants.SUNK_METRES;
    }
}
