package nephele.engine.walk;

import nephele.engine.collision.rigid.Bodies;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import nephele.engine.scene.Moment;
import nephele.engine.sim.Changeable;
import nephele.engine.sim.PlayerPose;
import nephele.engine.sim.Shots;
import nephele.engine.sim.SimState;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The frame state of a game between two ticks. A body that went through portals in the tick is interpolated along the
 * straight path through them and drawn on the side of each that it has reached; likewise the character.
 */
final class LiveMoment {
    private static final double EYE_BELOW_CROWN_METRES = 0.15;

    private final Moment moment;
    private final Vector3d centre = new Vector3d();
    private final Vector3d later = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Quaterniond laterTurn = new Quaterniond();

    LiveMoment(Level level) {
        moment = Moment.atStart(level);
    }

    /** Returns the frame state, always the same object. */
    Moment moment() {
        return moment;
    }

    /** Sets the portals of the later state, and the bodies at a share of the tick. */
    void world(SimState before, SimState after, double share, PortalAges ages) {
        Changeable around = after.around();
        moment.portals(around.portals());
        for (Shots.Colour shot : Shots.Colour.values()) {
            int portal = around.shots().portal(shot);
            if (portal != Shots.UNFIRED) {
                moment.look(portal, shot.ordinal(), ages.openness(portal, after.tick(), share));
            }
        }
        for (int body = 0; body < around.bodies().size(); body++) {
            body(body, before.around().bodies(), around.bodies(), share);
        }
    }

    private void body(int body, Bodies before, Bodies after, double share) {
        Portals portals = moment.portals();
        before.centre(body, centre);
        before.orientation(body, turn);
        int crossings = after.crossings(body);
        for (int i = 0; i < crossings; i++) {
            portals.passage(after.crossing(body, i)).point(centre);
            portals.passage(after.crossing(body, i)).orientation(turn);
        }
        centre.lerp(after.centre(body, later), share);
        turn.slerp(after.orientation(body, laterTurn), share);
        for (int i = crossings - 1; i >= 0; i--) {
            int exit = portals.partner(after.crossing(body, i));
            if (portals.portal(exit).inFront(centre.x, centre.y, centre.z) >= 0) {
                break;
            }
            portals.passage(exit).point(centre);
            portals.passage(exit).orientation(turn);
        }
        moment.body(body, centre, turn.normalize());
    }

    /**
     * Sets the held body.
     *
     * @param fromCamera its position relative to the camera: right, up and back
     * @param clarity transparency of the held body, 0 (as other bodies) to 1
     */
    void held(SimState after, Vec3 fromCamera, double clarity) {
        if (clarity == 0) {
            moment.nothingHeld();
        } else {
            moment.held(after.around().holding().body(), fromCamera, clarity);
        }
    }

    /** Sets the player's character and the time. */
    void figure(PlayerPose pose, Limbs limbs, double seconds) {
        PlayerPose.Body body = pose.body();
        moment.seconds(seconds);
        Vector3d middle = middle(body, limbs.heightMetres());
        moment.figure(beyondPortals(
                body.centre(),
                new Moment.Posture(
                        Vec3.of(middle),
                        body.up(),
                        body.yawRadians(),
                        body.pitchRadians(),
                        limbs.heightMetres(),
                        limbs.step(),
                        limbs.stride(),
                        limbs.travelRadians(),
                        limbs.airborne(),
                        limbs.carrying())));
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
    private Moment.Posture beyondPortals(Vec3 from, Moment.Posture posture) {
        Portals portals = moment.portals();
        if (portals.size() == 0) {
            return posture;
        }
        Moment.Posture there = posture;
        var trace = new PathTrace(portals, Obstacles.NONE);
        trace.walk(from.toVector(), posture.centre().toVector().sub(from.toVector()));
        for (int i = 0; i < trace.crossings(); i++) {
            there = there.through(portals.passage(trace.entered(i)));
        }
        return there;
    }
}
