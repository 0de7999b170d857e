package nephele.engine.sim.player;

import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import nephele.engine.sim.state.WorldState.HeldBody;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The player's pose between two ticks, for rendering. A tick in which the player went through portals is interpolated
 * in the space behind the last one: the earlier state is mapped there, so that nothing sweeps through the room. The eye
 * may be beyond a portal; it is then given in the space that it sees, the body in its own.
 *
 * @param eye in the space of the eye
 * @param view camera basis, in the space of the eye
 * @param later the view in the space of the later state, even if the eye has not passed all portals of the tick
 */
public record PlayerPose(Vec3 eye, Basis view, Body body, Basis later) {
    /** The body, in the space of its centre. */
    public record Body(Vec3 centre, Vec3 eye, Vec3 up, double yawRadians, double pitchRadians) {}

    /**
     * Interpolates between two successive states.
     *
     * @param fraction the fraction of the tick that has passed, 0 to 1; the yaw turns by the shorter way
     */
    public static PlayerPose between(SimState before, SimState after, double fraction) {
        PlayerState a = before.player();
        PlayerState b = after.player();
        CrossingWord crossed = after.world().trace().playerCrossed();
        Portals portals = after.world().portals();
        Vec3 centre = brought(a.centre(), crossed, portals).lerp(b.centre(), fraction);
        Vec3 eye = brought(a.eye(), crossed, portals).lerp(b.eye(), fraction);
        Basis view = crossed.length() == 0 && a.tilt().isViewLevel() && b.tilt().isViewLevel()
                ? level(a.heading(), b.heading(), fraction)
                : turned(brought(a.view(), crossed, portals), b.view(), fraction);
        Vec3 up = up(a.tilt().up(), b.tilt().up(), crossed, portals, fraction);
        int ahead = crossingsAhead(centre, crossed, portals);
        ViewAngles from = ahead > 0 || crossed.length() == 0 ? a.heading() : b.heading();
        double yaw = yaw(from, b.heading(), ahead > 0 ? 0 : fraction);
        double pitch = pitch(from, b.heading(), ahead > 0 ? 0 : fraction);
        var there = new PlayerPose(eye, view, new Body(centre, eye, up, yaw, pitch), view);
        return portals.size() == 0 ? there : there.back(ahead, crossed, portals).toEye(portals);
    }

    /**
     * Returns the centre of the held body relative to the eye, metres to the right, up and back, along the portals in
     * between; {@code null} if nothing is held or one of these portals has just been closed.
     */
    public static Vec3 heldFromEye(SimState state) {
        HeldBody holding = state.world().holding();
        Portals portals = state.world().portals();
        if (!holding.isHolding() || !holding.isOpen(portals)) {
            return null;
        }
        Vector3d path = holding.pointHere(state.world().bodies().centre(holding.body(), new Vector3d()), portals)
                .sub(state.player().eye().toVector());
        Basis view = state.player().view();
        return new Vec3(
                path.dot(view.right().toVector()),
                path.dot(view.up().toVector()),
                path.dot(view.back().toVector()));
    }

    private static double yaw(ViewAngles a, ViewAngles b, double fraction) {
        return a.yawRadians() + fraction * a.yawRadiansTo(b);
    }

    private static double pitch(ViewAngles a, ViewAngles b, double fraction) {
        return a.pitchRadians() + (b.pitchRadians() - a.pitchRadians()) * fraction;
    }

    private static Vec3 up(Vec3 a, Vec3 b, CrossingWord crossed, Portals portals, double fraction) {
        Vector3d earlier = a.toVector();
        for (int i = 0; i < crossed.length(); i++) {
            portals.transform(crossed.entry(i)).direction(earlier);
        }
        Vec3 from = Vec3.of(earlier);
        return from.equals(b) ? b : Directions.slerp(from, b, fraction);
    }

    /** Maps a direction of the later state's space into the eye's, in place. */
    public Vector3d fromLater(Vector3d direction) {
        double x = later.right().toVector().dot(direction);
        double y = later.up().toVector().dot(direction);
        double z = later.back().toVector().dot(direction);
        return direction
                .set(0, 0, 0)
                .fma(x, view.right().toVector())
                .fma(y, view.up().toVector())
                .fma(z, view.back().toVector());
    }

    private static Basis level(ViewAngles a, ViewAngles b, double fraction) {
        return Basis.ofYawPitch(yaw(a, b, fraction), pitch(a, b, fraction));
    }

    private static Basis turned(Basis a, Basis b, double fraction) {
        Quaterniond turn = Rotations.slerp(
                Rotations.ofAxes(a.right(), a.up(), a.back()), Rotations.ofAxes(b.right(), b.up(), b.back()), fraction);
        return new Basis(
                Vec3.of(turn.transform(new Vector3d(1, 0, 0))),
                Vec3.of(turn.transform(new Vector3d(0, 1, 0))),
                Vec3.of(turn.transform(new Vector3d(0, 0, 1))));
    }

    private static Vec3 brought(Vec3 point, CrossingWord crossed, Portals portals) {
        Vec3 moved = point;
        for (int i = 0; i < crossed.length(); i++) {
            moved = portals.transform(crossed.entry(i)).point(moved);
        }
        return moved;
    }

    private static Basis brought(Basis view, CrossingWord crossed, Portals portals) {
        Basis moved = view;
        for (int i = 0; i < crossed.length(); i++) {
            moved = portals.transform(crossed.entry(i)).basis(moved);
        }
        return moved;
    }

    /** Returns how many of the tick's last crossings are still ahead of an interpolated place. */
    private static int crossingsAhead(Vec3 centre, CrossingWord crossed, Portals portals) {
        Vec3 from = centre;
        for (int i = crossed.length() - 1; i >= 0; i--) {
            int exit = portals.partner(crossed.entry(i));
            if (portals.portal(exit).inFront(from.x(), from.y(), from.z()) >= 0) {
                return crossed.length() - 1 - i;
            }
            from = portals.transform(exit).point(from);
        }
        return crossed.length();
    }

    /** Maps the pose back through the last crossings. */
    private PlayerPose back(int crossings, CrossingWord crossed, Portals portals) {
        PlayerPose there = this;
        for (int i = 1; i <= crossings; i++) {
            PortalTransform by = portals.transform(portals.partner(crossed.entry(crossed.length() - i)));
            Body was = there.body;
            Body body = new Body(
                    by.point(was.centre), by.point(was.eye), by.direction(was.up), was.yawRadians, was.pitchRadians);
            there = new PlayerPose(body.eye, by.basis(there.view), body, later);
        }
        return there;
    }

    /** Maps eye and view through the portals between the body's centre and the eye. */
    private PlayerPose toEye(Portals portals) {
        var toEye = new PathTrace(portals, Obstacles.NONE);
        toEye.trace(body.centre.toVector(), body.eye.toVector().sub(body.centre.toVector()));
        Basis exitView = view;
        for (int i = 0; i < toEye.crossings(); i++) {
            exitView = portals.transform(toEye.entered(i)).basis(exitView);
        }
        return toEye.crossings() == 0 ? this : new PlayerPose(Vec3.of(toEye.place()), exitView, body, later);
    }
}
