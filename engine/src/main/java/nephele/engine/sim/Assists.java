package nephele.engine.sim;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import org.joml.Vector3d;

/**
 * Applies the enabled {@link Assist}s. They depend on the state and the input alone, so replays with assists repeat as
 * exactly as those without.
 */
public final class Assists {
    /**
     * In m/s. It raises the centre by 1.5 m: a standing player's feet reach 0.6 m above the floor, which leaves half a
     * second to step to the rim.
     */
    public static final double MIN_FLOOR_EXIT_METRES_PER_SECOND = 5.5;

    /** The speed cap of player and bodies, m/s. */
    public static final double MAX_METRES_PER_SECOND = 50;
    /** A portal is a floor exit if its unit normal has at least this upward component. */
    private static final double MIN_FLOOR_NORMAL_Y = 0.7;

    /**
     * The funnel acts on a player that would hit the portal's plane within this distance of the aperture and this time,
     * approaches at least at this speed (m/s) and looks towards it (cosine).
     */
    private static final double FUNNEL_METRES = 1;

    private static final double FUNNEL_SECONDS = 3;
    /**
     * The shortest time in which the funnel centres the player: a shorter one would let the lateral sway grow from pass
     * to pass.
     */
    private static final double FUNNEL_SHORTEST_SECONDS = 0.35;

    private static final double FUNNEL_MIN_METRES_PER_SECOND = 2;
    private static final double FUNNEL_MIN_VIEW_COSINE = 0.9;

    private final boolean funnels;
    private final boolean lifts;
    private final boolean caps;
    private final double seconds;
    private final Vector3d velocity = new Vector3d();
    private final Vector3d lateral = new Vector3d();

    Assists(SimSettings settings) {
        funnels = settings.assists().contains(Assist.FUNNEL);
        lifts = settings.assists().contains(Assist.FLOOR_EXIT_SPEED);
        caps = settings.assists().contains(Assist.SPEED_CAP);
        seconds = 1.0 / settings.ticksPerSecond();
    }

    /** Applies the funnel, before the player moves. Any move input disables it, so that the player can always leave. */
    PlayerState before(PlayerState player, PlayerInput input, Portals portals) {
        boolean steers = input.forwardPercent() != 0 || input.rightPercent() != 0;
        if (!funnels || steers || player.isGrounded()) {
            return player;
        }
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i) && isFallingInto(portals.portal(i), player)) {
                return led(player);
            }
        }
        return player;
    }

    /** Returns true if the funnel acts; {@link #lateral} is then the velocity change that it wants. */
    private boolean isFallingInto(Portal portal, PlayerState player) {
        Vec3 n = portal.normal();
        Vec3 v = player.velocity();
        Vec3 c = player.centre();
        double height = portal.inFront(c.x(), c.y(), c.z());
        double approach = -(n.dot(v));
        if (n.y() < MIN_FLOOR_NORMAL_Y
                || height <= 0
                || approach < FUNNEL_MIN_METRES_PER_SECOND
                || !looksAt(portal, player)) {
            return false;
        }
        double gravity = PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED * n.y();
        double t = 2 * height / (approach + Math.sqrt(approach * approach + 2 * gravity * height));
        double fall = PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED * t * t / 2;
        double x = c.x() + v.x() * t;
        double y = c.y() + v.y() * t - fall;
        double z = c.z() + v.z() * t;
        double outside = portal.aperture().outside(portal.across(x, y, z), portal.upward(x, y, z));
        if (t > FUNNEL_SECONDS || outside > FUNNEL_METRES) {
            return false;
        }
        lead(portal, c, v, Math.max(t, FUNNEL_SHORTEST_SECONDS));
        return true;
    }

    /** Sets {@link #lateral} to the change that brings the player over the portal's centre within {@code t} seconds. */
    private void lead(Portal portal, Vec3 c, Vec3 v, double t) {
        Vector3d right = portal.frame().right().toVector();
        Vector3d up = portal.frame().up().toVector();
        velocity.set(v.x(), v.y(), v.z());
        lateral.set(right).mul(-portal.across(c.x(), c.y(), c.z()) / t - velocity.dot(right));
        lateral.fma(-portal.upward(c.x(), c.y(), c.z()) / t - velocity.dot(up), up);
    }

    /** Returns true if the view is directed at the portal's centre or along the inverted portal normal. */
    private static boolean looksAt(Portal portal, PlayerState player) {
        Vector3d ahead = player.ahead(new Vector3d());
        Vector3d to = portal.centre().toVector().sub(player.eye().toVector());
        return ahead.dot(to) >= FUNNEL_MIN_VIEW_COSINE * to.length()
                || -ahead.dot(portal.normal().toVector()) >= FUNNEL_MIN_VIEW_COSINE;
    }

    private PlayerState led(PlayerState player) {
        double most = PlayerDimensions.AIR_METRES_PER_SECOND_SQUARED * seconds;
        double wanted = lateral.length();
        if (wanted == 0) {
            return player;
        }
        Vec3 v = player.velocity();
        lateral.mul(Math.min(1, most / wanted)).add(v.x(), v.y(), v.z());
        return player.withVelocity(Vec3.of(lateral));
    }

    /** Applies the least floor exit speed and the speed cap, after the player has moved. */
    PlayerState after(PlayerState player, CrossingWord crossed, Portals portals) {
        PlayerState lifted = player;
        if (lifts && crossed.length() > 0) {
            int exit = portals.partner(crossed.entry(crossed.length() - 1));
            lifted = liftedOut(player, portals.portal(exit));
        }
        Vec3 v = lifted.velocity();
        double speed = velocity.set(v.x(), v.y(), v.z()).length();
        return caps && speed > MAX_METRES_PER_SECOND
                ? lifted.withVelocity(Vec3.of(velocity.mul(MAX_METRES_PER_SECOND / speed)))
                : lifted;
    }

    private PlayerState liftedOut(PlayerState player, Portal exit) {
        Vec3 n = exit.normal();
        Vec3 v = player.velocity();
        double speed = n.dot(v);
        if (n.y() < MIN_FLOOR_NORMAL_Y || speed >= MIN_FLOOR_EXIT_METRES_PER_SECOND) {
            return player;
        }
        velocity.set(v.x(), v.y(), v.z()).fma(MIN_FLOOR_EXIT_METRES_PER_SECOND - speed, n.toVector());
        return player.withVelocity(Vec3.of(velocity));
    }

    /** Applies the speed cap to the bodies, after they have moved. */
    SimState limited(SimState moved) {
        return caps ? moved.with(moved.world().with(limited(moved.world().bodies()))) : moved;
    }

    private Bodies limited(Bodies bodies) {
        Bodies capped = bodies;
        for (int i = 0; i < bodies.size(); i++) {
            double speed = bodies.velocity(i, velocity).length();
            if (speed > MAX_METRES_PER_SECOND) {
                BodyState state = bodies.state(i);
                capped = capped.with(
                        i, state.moving(Vec3.of(velocity.mul(MAX_METRES_PER_SECOND / speed)), state.spin()));
            }
        }
        return capped;
    }
}
