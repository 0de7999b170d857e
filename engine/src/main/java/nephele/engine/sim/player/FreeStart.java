package nephele.engine.sim.player;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Depenetration;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions.Stance;
import org.joml.Vector3d;

/** Finds a place for a player who shall start where a camera is, which may be near a wall or in it. */
public final class FreeStart {
    private FreeStart() {}

    /** Returns the start with its feet below a standing player's eye. */
    public static PlayerStart below(Vec3 eye, double yawDegrees, double pitchDegrees) {
        var feet = new Vec3(eye.x(), eye.y() - Stance.STANDING.eyeMetres(), eye.z());
        return new PlayerStart(feet, yawDegrees, Math.max(-90, Math.min(90, pitchDegrees)));
    }

    /** Returns a start nearby in which the player overlaps no solid; the same one if there is none. */
    public static PlayerStart near(CollisionWorld world, PlayerStart start) {
        Vec3 feet = start.feet();
        Vector3d centre = new Vector3d(feet.x(), feet.y() + Stance.STANDING.centreAboveFeet(), feet.z());
        Vector3d out = new Vector3d();
        boolean isFound = new Depenetration().find(world, Stance.STANDING.shape(), centre, out);
        return isFound ? new PlayerStart(feet.plus(Vec3.of(out)), start.yawDegrees(), start.pitchDegrees()) : start;
    }
}
