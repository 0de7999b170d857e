package nephele.host.playthrough;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portals;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.state.SimState;
import org.joml.Vector3d;

/**
 * The third-person camera boom: behind and above the right shoulder, on a spring, through portals, shortened by
 * obstacles. It moves with the ticks, so that the frame rate does not affect it; frames interpolate between two ticks.
 */
final class CameraBoom {
    private static final double RIGHT_METRES = 0.5;
    private static final double UP_METRES = 0.3;
    private static final double BACK_METRES = 2.6;
    /** Greatest lag of the camera behind its rest position, however hard a landing. */
    private static final double MOST_LAG_METRES = 0.5;

    private static final double FARTHEST_METRES = 500;

    private final double secondsPerTick;
    private final CameraBoomReach reach;
    private final Vector3d boom = new Vector3d();
    private boolean wanted;
    private CameraBoomState before = CameraBoomState.FOLDED;
    private CameraBoomState after = CameraBoomState.FOLDED;

    CameraBoom(CollisionWorld statics, double secondsPerTick) {
        this.secondsPerTick = secondsPerTick;
        reach = new CameraBoomReach(statics);
    }

    /** Switches between first and third person; the camera moves gradually. */
    void toggle() {
        wanted = !wanted;
    }

    boolean isOut() {
        return wanted || after.extent() > 0 || before.extent() > 0;
    }

    /** Follows a tick from one state to another. */
    void tick(SimState earlier, SimState later) {
        before = after;
        if (isOut()) {
            PlayerPose pose = PlayerPose.between(earlier, later, 1);
            CameraBoomState there = entering(earlier, later).after(secondsPerTick, wanted ? 1 : 0);
            double free = reach.free(portals(later), pose.eye().toVector(), boom(pose, there));
            after = there.notBeyond(free);
        }
    }

    /** Moves the camera at once, after a discontinuity of the player's motion. */
    void cut() {
        after = new CameraBoomState(CameraSpring.AT_REST, Vec3.ZERO, after.extent());
        before = after;
    }

    /**
     * Returns the camera at a fraction of the tick between two states.
     *
     * @param aimed a point in the eye's space; mapped to the camera's space
     */
    PlayerPose camera(SimState earlier, SimState later, double fraction, Vector3d aimed) {
        PlayerPose pose = PlayerPose.between(earlier, later, fraction);
        stretch(pose, earlier, later, fraction);
        PathTrace trace = reach.trace(portals(later));
        trace.trace(pose.eye().toVector(), boom);
        trace.carryPoint(aimed);
        return new PlayerPose(
                Vec3.of(trace.place()), carried(pose.view(), trace, portals(later)), pose.body(), pose.later());
    }

    /** Returns the vector from eye to camera at a fraction of the tick, in the axes of the view: right, up and back. */
    Vec3 offset(SimState earlier, SimState later, double fraction) {
        PlayerPose pose = PlayerPose.between(earlier, later, fraction);
        stretch(pose, earlier, later, fraction);
        return new Vec3(
                boom.dot(pose.view().right().toVector()),
                boom.dot(pose.view().up().toVector()),
                boom.dot(pose.view().back().toVector()));
    }

    private void stretch(PlayerPose pose, SimState earlier, SimState later, double fraction) {
        CameraBoomState there = entering(earlier, later).after(fraction * secondsPerTick, wanted ? 1 : 0);
        boom(pose, there);
        boom.mul(Math.min(there.extent(), reach.free(portals(later), pose.eye().toVector(), boom)));
    }

    /** Returns the first hit of a straight line from the eye. */
    Vector3d aimedAt(PlayerPose pose) {
        return hit(pose.eye(), pose.view().back().toVector().negate());
    }

    /** Returns the first hit of a straight line in a direction, which this changes. */
    Vector3d hit(Vec3 from, Vector3d direction) {
        Vector3d start = from.toVector();
        Vector3d line = direction.mul(FARTHEST_METRES);
        return start.fma(reach.freeOfSolids(start, line), line);
    }

    private static Basis carried(Basis view, PathTrace trace, Portals portals) {
        Basis moved = view;
        for (int i = 0; i < trace.crossings(); i++) {
            moved = portals.transform(trace.entered(i)).basis(moved);
        }
        return moved;
    }

    private static Portals portals(SimState state) {
        return state.world().portals();
    }

    /** Returns the state before the tick, mapped to the space after it, with the tick's velocity. */
    private CameraBoomState entering(SimState earlier, SimState later) {
        CrossingWord crossed = later.world().trace().playerCrossed();
        Portals portals = portals(later);
        Vec3 from = earlier.player().eye();
        for (int i = 0; i < crossed.length(); i++) {
            from = portals.transform(crossed.entry(i)).point(from);
        }
        Vector3d velocity = later.player().eye().toVector().sub(from.toVector()).div(secondsPerTick);
        return before.through(crossed, portals).restingAt(Vec3.of(velocity));
    }

    /** Returns the vector from the eye to the camera without obstacles, in the eye's space. */
    private Vector3d boom(PlayerPose pose, CameraBoomState state) {
        Vector3d lag = pose.fromLater(state.spring().lag().toVector());
        lag.div(Math.sqrt(1 + lag.lengthSquared() / (MOST_LAG_METRES * MOST_LAG_METRES)));
        return boom.set(lag)
                .fma(RIGHT_METRES, pose.view().right().toVector())
                .fma(UP_METRES, pose.view().up().toVector())
                .fma(BACK_METRES, pose.view().back().toVector());
    }
}
