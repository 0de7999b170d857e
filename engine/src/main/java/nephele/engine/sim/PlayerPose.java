package nephele.engine.sim;

import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Passage;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Where the player's eye is and looks between two ticks: what rendering needs of the simulation. A tick in which the
 * player went through portals is seen from behind the last one: the earlier state is moved there as if it had been on
 * the straight way in, and nothing sweeps through the room. An eye beyond a portal is where it sees, not the body.
 */
public record PlayerPose(Vec3 eye, Basis view) {
    /** @param share of the tick that has passed, 0 to 1; yaw turns by the shorter way */
    public static PlayerPose between(SimState before, SimState after, double share) {
        PlayerState a = before.player();
        PlayerState b = after.player();
        CrossingWord crossed = after.around().trace().playerCrossed();
        Portals portals = after.around().portals();
        if (portals.size() == 0) {
            return new PlayerPose(mix(a.eye(), b.eye(), share), level(a.heading(), b.heading(), share));
        }
        Vec3 centre = mix(brought(a.centre(), crossed, portals), b.centre(), share);
        Vec3 eye = mix(brought(a.eye(), crossed, portals), b.eye(), share);
        Basis view = crossed.length() == 0 && a.tilt().isViewLevel() && b.tilt().isViewLevel()
                ? level(a.heading(), b.heading(), share)
                : turned(brought(PlayerEye.view(a), crossed, portals), PlayerEye.view(b), share);
        return seenFrom(centre, new PlayerPose(eye, view), crossed, portals);
    }

    private static Basis level(Heading a, Heading b, double share) {
        double yaw = a.yawRadians() + share * a.yawRadiansTo(b);
        double pitch = a.pitchRadians() + (b.pitchRadians() - a.pitchRadians()) * share;
        return Basis.ofYawPitch(yaw, pitch);
    }

    private static Basis turned(Basis a, Basis b, double share) {
        Quaterniond turn = Rotations.slerp(
                Rotations.ofAxes(a.right(), a.up(), a.back()), Rotations.ofAxes(b.right(), b.up(), b.back()), share);
        return new Basis(
                Vec3.of(turn.transform(new Vector3d(1, 0, 0))),
                Vec3.of(turn.transform(new Vector3d(0, 1, 0))),
                Vec3.of(turn.transform(new Vector3d(0, 0, 1))));
    }

    private static Vec3 brought(Vec3 point, CrossingWord crossed, Portals portals) {
        Vec3 moved = point;
        for (int i = 0; i < crossed.length(); i++) {
            moved = portals.passage(crossed.entry(i)).point(moved);
        }
        return moved;
    }

    private static Basis brought(Basis view, CrossingWord crossed, Portals portals) {
        Basis moved = view;
        for (int i = 0; i < crossed.length(); i++) {
            moved = turned(moved, portals.passage(crossed.entry(i)));
        }
        return moved;
    }

    private static Basis turned(Basis view, Passage by) {
        return new Basis(by.direction(view.right()), by.direction(view.up()), by.direction(view.back()));
    }

    /** Undoes the crossings that lie ahead of a place in the tick, then goes from the body's centre to the eye. */
    private static PlayerPose seenFrom(Vec3 centre, PlayerPose pose, CrossingWord crossed, Portals portals) {
        Vec3 from = centre;
        PlayerPose there = pose;
        for (int i = crossed.length() - 1; i >= 0; i--) {
            int exit = portals.partner(crossed.entry(i));
            if (portals.portal(exit).inFront(from.x(), from.y(), from.z()) >= 0) {
                break;
            }
            Passage back = portals.passage(exit);
            from = back.point(from);
            there = new PlayerPose(back.point(there.eye), turned(there.view, back));
        }
        var toEye = new PathTrace(portals, Obstacles.NONE);
        toEye.walk(from.toVector(), there.eye.toVector().sub(from.toVector()));
        Basis view = there.view;
        for (int i = 0; i < toEye.crossings(); i++) {
            view = turned(view, portals.passage(toEye.entered(i)));
        }
        return toEye.crossings() == 0 ? there : new PlayerPose(Vec3.of(toEye.place()), view);
    }

    private static Vec3 mix(Vec3 a, Vec3 b, double share) {
        return new Vec3(
                a.x() + (b.x() - a.x()) * share, a.y() + (b.y() - a.y()) * share, a.z() + (b.z() - a.z()) * share);
    }
}
