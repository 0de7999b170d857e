package nephele.host.playthrough;

import java.util.List;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The frame state of a game between two ticks. A body that went through portals in the tick is interpolated along the
 * straight path through them and drawn on the side of each that it has reached; likewise the character.
 */
final class FrameInterpolation {
    private static final double EYE_BELOW_CROWN_METRES = 0.15;

    private final FrameState frameState;
    private final Vector3d centre = new Vector3d();
    private final Vector3d later = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Quaterniond laterTurn = new Quaterniond();

    FrameInterpolation(Level level) {
        frameState = FrameState.atStart(level);
    }

    /** Returns the frame state, always the same object. */
    FrameState frameState() {
        return frameState;
    }

    /** Sets the portals of the later state, and the bodies at a fraction of the tick. */
    void world(SimState before, SimState after, double fraction, PortalAges ages) {
        WorldState around = after.world();
        frameState.portals(around.portals());
        for (int i = 0; i < GunPortals.Colour.BOTH.size(); i++) {
            GunPortals.Colour shot = GunPortals.Colour.BOTH.get(i);
            int portal = around.shots().portal(shot);
            if (portal != GunPortals.UNFIRED) {
                frameState.setPortalLook(portal, shot.ordinal(), ages.openness(portal, after.tick(), fraction));
            }
        }
        for (int body = 0; body < around.bodies().size(); body++) {
            body(
                    body,
                    isReturned(after, body) ? around.bodies() : before.world().bodies(),
                    around.bodies(),
                    fraction);
        }
    }

    /** Returns true if a body came back into the world in the tick: it was nowhere on the way. */
    private static boolean isReturned(SimState after, int body) {
        List<TickEvent> events = after.world().trace().events();
        for (int i = 0; i < events.size(); i++) {
            if (events.get(i) instanceof TickEvent.BodyReturned returned && returned.body() == body) {
                return true;
            }
        }
        return false;
    }

    private void body(int body, Bodies before, Bodies after, double fraction) {
        Portals portals = frameState.portals();
        before.centre(body, centre);
        before.orientation(body, turn);
        int crossings = before == after ? 0 : after.crossings(body);
        for (int i = 0; i < crossings; i++) {
            portals.transform(after.crossing(body, i)).point(centre);
            portals.transform(after.crossing(body, i)).orientation(turn);
        }
        centre.lerp(after.centre(body, later), fraction);
        turn.slerp(after.orientation(body, laterTurn), fraction);
        for (int i = crossings - 1; i >= 0; i--) {
            int exit = portals.partner(after.crossing(body, i));
            if (portals.portal(exit).inFront(centre.x, centre.y, centre.z) >= 0) {
                break;
            }
            portals.transform(exit).point(centre);
            portals.transform(exit).orientation(turn);
        }
        frameState.body(body, centre, turn.normalize());
    }

    /**
     * Sets the held body.
     *
     * @param fromCamera its position relative to the camera: right, up and back
     * @param clarity transparency of the held body, 0 (as other bodies) to 1
     */
    void held(SimState after, Vec3 fromCamera, double clarity) {
        if (clarity == 0) {
            frameState.nothingHeld();
        } else {
            frameState.held(after.world().holding().body(), fromCamera, clarity);
        }
    }

    /**
     * Sets the player's character and the time.
     *
     * @param dip metres by which the character bends its legs
     */
    void character(PlayerPose pose, AnimationState animation, double dip, double seconds) {
        PlayerPose.Body body = pose.body();
        frameState.seconds(seconds);
        double height = animation.heightMetres() - dip;
        Vector3d middle = middle(body, height).fma(-dip, body.up().toVector());
        frameState.character(beyondPortals(
                body.centre(),
                new FrameState.Posture(
                        Vec3.of(middle),
                        body.up(),
                        body.yawRadians(),
                        body.pitchRadians(),
                        height,
                        animation.step(),
                        animation.stride(),
                        animation.travelRadians(),
                        animation.airborne(),
                        animation.carrying())));
    }

    /**
     * Returns the point half the character's height below its crown, which follows the eye; in the space of the body's
     * centre.
     */
    private static Vector3d middle(PlayerPose.Body body, double heightMetres) {
        return body.eye()
                .toVector()
                .fma(EYE_BELOW_CROWN_METRES - heightMetres / 2, body.up().toVector());
    }

    /** Maps the posture through the portals between the body's centre and the character's middle. */
    private FrameState.Posture beyondPortals(Vec3 from, FrameState.Posture posture) {
        Portals portals = frameState.portals();
        if (portals.size() == 0) {
            return posture;
        }
        FrameState.Posture there = posture;
        var trace = new PathTrace(portals, Obstacles.NONE);
        trace.trace(from.toVector(), posture.centre().toVector().sub(from.toVector()));
        for (int i = 0; i < trace.crossings(); i++) {
            there = there.through(portals.transform(trace.entered(i)));
        }
        return there;
    }
}
