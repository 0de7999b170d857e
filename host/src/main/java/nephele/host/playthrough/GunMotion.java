package nephele.host.playthrough;

import java.util.List;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Vec3;
import nephele.engine.scene.GunInHand;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;

/**
 * The motion of the gun in the hand after a tick: it lags behind turns and kicks back at shots. A function of the ticks
 * and their events; the simulation does not depend on it.
 *
 * @param yawLag by which the gun points behind the view's turn to the left, radians; {@code pitchLag} likewise upwards
 * @param second 0 while the first shot is next, 1 for the second; it changes gradually
 * @param opened the last shot that opened a portal; the other one is next
 * @param shot the last shot, with or without a portal
 * @param shotTick its tick; {@link #NEVER} before the first
 */
record GunMotion(
        double yawLag,
        double pitchLag,
        double second,
        GunPortals.Colour opened,
        GunPortals.Colour shot,
        long shotTick) {
    private static final long NEVER = Long.MIN_VALUE / 2;

    static final GunMotion AT_REST = new GunMotion(0, 0, 0, GunPortals.Colour.SECOND, GunPortals.Colour.SECOND, NEVER);

    /** The fraction of a turn by which the gun lags, and how fast it follows. */
    private static final double LAG_FRACTION = 0.14;

    private static final double FOLLOWING_PER_SECOND = 9;
    private static final double MOST_LAG_RADIANS = 0.07;
    private static final double LAMP_CHANGES_PER_SECOND = 7;

    private static final Vec3 PLACE = new Vec3(0.225, -0.197, -0.56);
    private static final double YAW_RADIANS = 0.05;
    private static final double PITCH_RADIANS = 0.035;
    private static final double KICK_SECONDS = 0.045;

    /** The muzzle from the eye at rest: right, up and back in metres. */
    static final Vec3 MUZZLE = new Vec3(0.208, -0.124, -0.905);

    /** Returns the motion after one more tick of this length. */
    GunMotion next(SimState before, SimState after, double seconds) {
        GunMotion fired = afterShots(after);
        double follow = Math.exp(-FOLLOWING_PER_SECOND * seconds);
        // Behind a portal the view has another yaw without any turn of the player's.
        boolean isTurn = after.world().trace().playerCrossed().length() == 0;
        PlayerState from = before.player();
        PlayerState to = after.player();
        double turn = isTurn ? from.heading().yawRadiansTo(to.heading()) : 0;
        double nod = isTurn ? to.heading().pitchRadians() - from.heading().pitchRadians() : 0;
        double target = fired.opened == GunPortals.Colour.FIRST ? 1 : 0;
        double step = LAMP_CHANGES_PER_SECOND * seconds;
        return new GunMotion(
                limited((yawLag + LAG_FRACTION * turn) * follow),
                limited((pitchLag + LAG_FRACTION * nod) * follow),
                second + Math.max(-step, Math.min(step, target - second)),
                fired.opened,
                fired.shot,
                fired.shotTick);
    }

    private GunMotion afterShots(SimState after) {
        GunMotion now = this;
        List<TickEvent> events = after.world().trace().events();
        for (int i = 0; i < events.size(); i++) {
            if (events.get(i) instanceof TickEvent.PortalOpened event) {
                now = new GunMotion(yawLag, pitchLag, second, event.shot(), event.shot(), after.tick());
            } else if (events.get(i) instanceof TickEvent.PortalRefused event) {
                now = new GunMotion(yawLag, pitchLag, second, now.opened, event.shot(), after.tick());
            }
        }
        return now;
    }

    private static double limited(double lag) {
        return Math.max(-MOST_LAG_RADIANS, Math.min(MOST_LAG_RADIANS, lag));
    }

    /** The moment between two ticks at which the gun is drawn. */
    record Moment(long tick, double fraction, double secondsPerTick, PictureMotion motion, FlashStyle flashes) {}

    /**
     * Returns the gun between this motion and that of the next tick.
     *
     * @param animation of the character at that moment
     * @param dip of the camera after a landing, metres
     */
    GunInHand at(Moment moment, GunMotion later, AnimationState animation, double dip) {
        double fraction = moment.fraction;
        double shotSeconds = (moment.tick - later.shotTick + fraction) * moment.secondsPerTick;
        double whole = moment.motion == PictureMotion.FULL ? 1 : 0;
        double kick = whole * kick(shotSeconds);
        double stride = whole * Math.min(1.3, animation.stride()) * (1 - animation.airborne());
        double swing = stride * Math.sin(2 * Math.PI * animation.step());
        double bounce = stride * Math.cos(4 * Math.PI * animation.step());
        double air = whole * animation.airborne();
        double breath = whole * Math.sin((moment.tick + fraction) * moment.secondsPerTick * Math.PI / 2.1);
        double yaw = whole * mix(yawLag, later.yawLag, fraction);
        double pitch = whole * mix(pitchLag, later.pitchLag, fraction);
        double low = animation.carrying() * animation.carrying() * (3 - 2 * animation.carrying());
        return new GunInHand(
                new Vec3(
                        PLACE.x() + 0.006 * swing + 0.25 * yaw + 0.03 * low,
                        PLACE.y()
                                - 0.004 * bounce
                                + 0.0012 * breath
                                + 0.01 * air
                                - 0.3 * dip
                                - 0.25 * pitch
                                - 0.11 * low,
                        PLACE.z() + 0.03 * kick + 0.02 * low),
                YAW_RADIANS - yaw + 0.008 * swing,
                PITCH_RADIANS - pitch + 0.07 * kick - 0.035 * air - 0.5 * dip - 0.55 * low,
                0.012 * swing + 0.5 * yaw + 0.12 * low,
                mix(second, later.second, fraction),
                flash(shotSeconds, moment.flashes),
                later.shot.ordinal());
    }

    private static double kick(double seconds) {
        double t = seconds / KICK_SECONDS;
        return t <= 0 ? 0 : t * Math.exp(1 - t);
    }

    private static double flash(double seconds, FlashStyle style) {
        if (seconds < 0) {
            return 0;
        }
        double bright = style == FlashStyle.SOFTENED
                ? 0.35 * Math.min(1, seconds / 0.06) * Math.exp(-seconds / 0.15)
                : Math.exp(-seconds / 0.06);
        return bright < 1e-3 ? 0 : bright;
    }

    private static double mix(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }
}
