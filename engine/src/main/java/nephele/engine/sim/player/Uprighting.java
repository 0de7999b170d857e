package nephele.engine.sim.player;

import nephele.engine.collision.Depenetration;
import nephele.engine.collision.RoundedHull;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.Tilt;
import nephele.engine.sim.state.ViewAngles;
import org.joml.Vector3d;

/**
 * Turns a player upright that came out of a portal tilted. The view turns at once, at a rate that the player can
 * choose. The body turns about its centre as far as there is room, never into a solid; in an aperture it waits while
 * turning would make it hit the rim.
 */
final class Uprighting {
    private static final double RADIANS_PER_SECOND = 2 * Math.PI;
    /**
     * The greatest angle of one rotation step. The head, 0.6 m from the centre, moves 3 cm in it: a tenth of the
     * capsule's radius.
     */
    private static final double MOST_RADIANS = Math.PI / 60;

    private static final double LOOK_AHEAD_SECONDS = 0.3;

    private final CharacterMover mover;
    private final Depenetration depenetration;
    private final double radians;
    private final double viewRadians;
    private final Vector3d way = new Vector3d();
    private final Vector3d raised = new Vector3d();

    Uprighting(CharacterMover mover, Depenetration depenetration, SimSettings settings) {
        this.mover = mover;
        this.depenetration = depenetration;
        double seconds = 1.0 / settings.ticksPerSecond();
        radians = RADIANS_PER_SECOND * seconds;
        boolean isAsBody = settings.uprightDegreesPerSecond() == SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
        viewRadians = isAsBody ? radians : Math.toRadians(settings.uprightDegreesPerSecond()) * seconds;
    }

    void turn(PlayerMotion player) {
        Tilt tilt = player.look().tilt();
        if (tilt.isUpright()) {
            return;
        }
        ViewAngles heading = player.look().heading();
        player.look(new PlayerView(heading, tilt.viewTowardsUpright(viewRadians)));
        int left = (int) Math.ceil(radians / MOST_RADIANS);
        double angle = radians / left;
        while (left > 0 && turnBody(player, heading, angle)) {
            left--;
        }
    }

    /** Turns the body by an angle too small to skip an obstacle. Returns false if it is upright or has no room. */
    private boolean turnBody(PlayerMotion player, ViewAngles heading, double angle) {
        Tilt tilt = player.look().tilt();
        if (tilt.isBodyUpright()) {
            return false;
        }
        Vec3 up = tilt.bodyTowardsUpright(angle, forward(heading));
        RoundedHull turned = PlayerMotion.shape(player.stance(), up);
        if (!standsUp(player, turned) && !hasRoom(player, turned)) {
            return false;
        }
        player.look(new PlayerView(heading, tilt.withBody(up)));
        return true;
    }

    private static Vec3 forward(ViewAngles heading) {
        return new Vec3(-StrictMath.sin(heading.yawRadians()), 0, -StrictMath.cos(heading.yawRadians()));
    }

    private boolean hasRoom(PlayerMotion player, RoundedHull turned) {
        if (!depenetration.isFree(mover.world(turned, player.place), turned, player.place)) {
            return false;
        }
        if (mover.active() == 0) {
            return true;
        }
        way.set(player.velocity).mul(LOOK_AHEAD_SECONDS);
        mover.isBlocked(player.shape(), player.place, way);
        double free = mover.lastSweep().fraction();
        mover.isBlocked(turned, player.place, way);
        return mover.lastSweep().fraction() >= free;
    }

    /**
     * Raises a grounded player by as much as its capsule reaches further down after the turn. Returns true if that
     * makes room.
     */
    private boolean standsUp(PlayerMotion player, RoundedHull turned) {
        double rise = player.shape().least(1) - turned.least(1);
        if (!(rise > 0) || !player.grounded) {
            return false;
        }
        raised.set(player.place);
        if (mover.advanceUntilHit(player.shape(), raised, way.set(0, rise, 0))) {
            return false;
        }
        boolean free = depenetration.isFree(mover.world(turned, raised), turned, raised);
        if (free) {
            player.place.set(raised);
        }
        return free;
    }
}
