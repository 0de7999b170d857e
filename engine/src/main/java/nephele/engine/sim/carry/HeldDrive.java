package nephele.engine.sim.carry;

import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.sim.player.PlayerEye;
import nephele.engine.sim.state.HeldBody;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import org.joml.Vector3d;

/**
 * Drives a held body to a place before the eye: computes a velocity that brings it there without overshooting, within
 * the limits of force, acceleration and speed. The body follows the player's own motion.
 */
final class HeldDrive {
    /** The gap between the player's capsule and the held body's bounding sphere. */
    private static final double GAP_METRES = 0.35;

    private static final double RATE_PER_SECOND = 15;
    /** The greatest speed relative to the player, m/s. */
    private static final double MAX_METRES_PER_SECOND = 8;

    private static final double MAX_NEWTONS = 1500;
    /** In m/s². It limits light bodies, which {@link #MAX_NEWTONS} alone would let jump. */
    private static final double MAX_METRES_PER_SECOND_SQUARED = 120;

    /** In rad/s. */
    private static final double MAX_RADIANS_PER_SECOND = 12;
    /** In m/s; heavy bodies are limited by {@link #THROW_NEWTON_SECONDS}. */
    private static final double THROW_METRES_PER_SECOND = 8;

    private static final double THROW_NEWTON_SECONDS = 160;

    private final BodyTable table;
    private final double seconds;
    private final Vector3d target = new Vector3d();
    private final Vector3d eye = new Vector3d();
    private final Vector3d ahead = new Vector3d();
    private final Vector3d carried = new Vector3d();

    HeldDrive(BodyTable table, double secondsPerTick) {
        this.table = table;
        seconds = secondsPerTick;
    }

    /** Returns the motion with which a held body starts this tick. */
    BodyState motion(SimState state, PlayerInput input, PortalWorld space) {
        HeldBody held = state.world().holding();
        Portals portals = space.portals();
        BodyState body = state.world().bodies().state(held.body());
        PlayerState player = state.player();
        held.pointThere(place(held, player, space), portals).sub(body.centre().toVector());
        Vec3 own = player.velocity();
        held.directionThere(carried.set(own.x(), own.y(), own.z()), portals);
        Vector3d velocity = approach(target, acceleration(held.body())).add(carried);
        limitChange(velocity, body.velocity().toVector(), acceleration(held.body()) * seconds);
        return body.moving(Vec3.of(velocity), spin(held, input, portals));
    }

    private double acceleration(int body) {
        return Math.min(MAX_METRES_PER_SECOND_SQUARED, MAX_NEWTONS / table.massKilograms(body));
    }

    /** Returns the target of the body's centre in the player's space, as if there were no portals. */
    private Vector3d place(HeldBody held, PlayerState player, PortalWorld space) {
        double reach = table.reachMetres(held.body());
        PlayerEye.eye(player, eye);
        PlayerEye.direction(PlayerEye.view(player), ahead);
        double metres = PlayerDimensions.RADIUS_METRES + GAP_METRES + reach;
        var sight = new LineOfSight(space.portals(), space::free);
        sight.look(player, target.set(eye).fma(metres + reach, ahead));
        double free = Math.max(0, Math.min(metres, sight.freeMetres() - reach / 2));
        return target.set(eye).fma(free, ahead);
    }

    /** Scales a displacement to a velocity towards its end, limited so that the body can stop there. */
    private Vector3d approach(Vector3d way, double acceleration) {
        double metres = way.length();
        if (metres == 0) {
            return way;
        }
        double stopping = 0.7 * Math.sqrt(2 * acceleration * metres);
        double speed = Math.min(
                MAX_METRES_PER_SECOND,
                Math.min(stopping, metres * -StrictMath.expm1(-RATE_PER_SECOND * seconds) / seconds));
        return way.mul(speed / metres);
    }

    private static void limitChange(Vector3d velocity, Vector3d before, double most) {
        velocity.sub(before);
        double change = velocity.length();
        velocity.mul(change > most ? most / change : 1).add(before);
    }

    /** Returns the spin that turns the held body with the player's yaw. */
    private Vec3 spin(HeldBody held, PlayerInput input, Portals portals) {
        double yaw = Math.toRadians(input.turnLeftMillidegrees() / 1000.0) / seconds;
        double limited = Math.max(-MAX_RADIANS_PER_SECOND, Math.min(MAX_RADIANS_PER_SECOND, yaw));
        return Vec3.of(held.directionThere(carried.set(0, limited, 0), portals));
    }

    /** Returns the motion of a body that is thrown along the view. */
    BodyState thrown(SimState state, Portals portals) {
        HeldBody held = state.world().holding();
        BodyState body = state.world().bodies().state(held.body());
        double speed = Math.min(THROW_METRES_PER_SECOND, THROW_NEWTON_SECONDS / table.massKilograms(held.body()));
        Vec3 own = state.player().velocity();
        PlayerEye.direction(PlayerEye.view(state.player()), ahead).mul(speed).add(own.x(), own.y(), own.z());
        return body.moving(Vec3.of(held.directionThere(ahead, portals)), body.spin());
    }
}
