package nephele.host.playthrough;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.FrameState.ShotEffect.Kind;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.MuzzleLight;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import org.joml.Vector3d;

/**
 * The light of the last shots: the muzzle's on the surfaces around, a bolt from the gun to the first surface, as shots go
 * through no portal, and a shimmer on a surface that took none. Functions of the ticks since the shot.
 */
final class ShotEffects {
    private static final double BOLT_SECONDS = 0.22;
    private static final double SHIMMER_SECONDS = 0.55;
    /** Time between shot and shimmer, in which the bolt arrives. */
    private static final double FLIGHT_SECONDS = 0.08;

    /** Distance from which on a shot has hit nothing that could shimmer. */
    private static final double SEEN_METRES = 150;

    /** Where a third-person character's shots begin, from its eye: right, up and back. */
    private static final Vec3 FROM_BODY = new Vec3(0.22, -0.42, -0.45);

    private static final double SLANT = 0.004;

    /** An effect with the time of its beginning in ticks and its duration. */
    private record Lasting(Kind kind, int colour, double beginTick, double seconds, Vec3 from, Vec3 to) {}

    /** The last shot that still may light surfaces; {@code null} without one. */
    private Lasting last;

    private final CameraBoom boom;
    private final double secondsPerTick;
    private final List<Lasting> lasting = new ArrayList<>();

    ShotEffects(CameraBoom boom, double secondsPerTick) {
        this.boom = boom;
        this.secondsPerTick = secondsPerTick;
    }

    /** Follows a tick; {@code tanHalfHeight} of the first-person view. */
    void after(SimState before, SimState after, double tanHalfHeight) {
        List<TickEvent> events = after.world().trace().events();
        for (int i = 0; i < events.size(); i++) {
            if (events.get(i) instanceof TickEvent.PortalOpened opened) {
                shoot(
                        PlayerPose.between(before, after, 1),
                        after.tick(),
                        opened.shot().ordinal(),
                        tanHalfHeight);
            } else if (events.get(i) instanceof TickEvent.PortalRefused refused) {
                PlayerPose pose = PlayerPose.between(before, after, 1);
                shoot(pose, after.tick(), refused.shot().ordinal(), tanHalfHeight);
                shimmer(pose, after.tick(), refused.shot().ordinal());
            }
        }
    }

    private void shoot(PlayerPose pose, long tick, int colour, double tanHalfHeight) {
        Vec3 end = Vec3.of(boom.aimedAt(pose));
        double wide = boom.isOut() ? 1 : GunInHand.widening(tanHalfHeight);
        Vec3 from = boom.isOut() ? FROM_BODY : GunMotion.MUZZLE;
        Basis view = pose.view();
        double metres = end.minus(pose.eye()).length();
        // Close to a wall the gun reaches through it, as it is drawn in front.
        double fraction = Math.min(1, 0.7 * metres / from.length());
        Vec3 muzzle = pose.eye()
                .addScaled(fraction * wide * from.x(), view.right())
                .addScaled(fraction * wide * from.y(), view.up())
                .addScaled(fraction * from.z(), view.back());
        last = new Lasting(Kind.BOLT, colour, tick, BOLT_SECONDS, muzzle, end);
        lasting.add(last);
    }

    private void shimmer(PlayerPose pose, long tick, int colour) {
        Vector3d middle = boom.aimedAt(pose);
        if (middle.distance(pose.eye().toVector()) > SEEN_METRES) {
            return;
        }
        Vec3 where = Vec3.of(middle);
        Vec3 normal = normal(pose, middle);
        double begin = tick + FLIGHT_SECONDS / secondsPerTick;
        lasting.add(new Lasting(Kind.SHIMMER, colour, begin, SHIMMER_SECONDS, where, where.plus(normal)));
    }

    /** Returns the unit normal of the surface at the aimed place, from two more hits beside it. */
    private Vec3 normal(PlayerPose pose, Vector3d middle) {
        Vector3d towardsEye = pose.view().back().toVector();
        Vector3d first = slanted(pose, pose.view().right()).sub(middle);
        Vector3d second = slanted(pose, pose.view().up()).sub(middle);
        Vector3d normal = first.cross(second);
        boolean isNone = !(normal.length() > 1e-12);
        return Vec3.of(isNone ? towardsEye : normal.normalize());
    }

    private Vector3d slanted(PlayerPose pose, Vec3 aside) {
        Vector3d direction = pose.view().back().toVector().negate();
        return boom.hit(pose.eye(), direction.fma(SLANT, aside.toVector()).normalize());
    }

    /** Forgets all, after a discontinuity. */
    void cut() {
        lasting.clear();
        last = null;
    }

    /** Returns the last shot's light on surfaces at a fraction of the tick that ends in {@code tick}; {@code null} for none. */
    MuzzleLight muzzleLight(long tick, double fraction, FlashStyle flashes) {
        if (last == null) {
            return null;
        }
        double seconds = (tick - last.beginTick + fraction) * secondsPerTick;
        double strength = MuzzleLight.strengthAfter(seconds, flashes);
        return strength > 0 ? new MuzzleLight(last.from, last.colour, strength) : null;
    }

    /** Returns the effects at a fraction of the tick that ends in {@code tick}. */
    List<FrameState.ShotEffect> at(long tick, double fraction) {
        lasting.removeIf(each -> (tick - each.beginTick) * secondsPerTick >= each.seconds);
        if (lasting.isEmpty()) {
            return List.of();
        }
        List<FrameState.ShotEffect> now = new ArrayList<>(lasting.size());
        for (Lasting each : lasting) {
            double age = (tick - each.beginTick + fraction) * secondsPerTick / each.seconds;
            if (age >= 0 && age < 1) {
                now.add(new FrameState.ShotEffect(each.kind, each.colour, age, each.from, each.to));
            }
        }
        return now;
    }
}
