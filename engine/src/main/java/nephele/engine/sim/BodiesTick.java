package nephele.engine.sim;

import nephele.engine.collision.rigid.Bodies;
import nephele.engine.collision.rigid.BodyState;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.collision.rigid.Influences;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** One tick of all bodies: they meet the player as a capsule and each other, and what is held is driven. */
final class BodiesTick {
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerBody.GRAVITY, 0);

    private final int bodies;
    private final RigidStep step;
    private final Spaces spaces;
    private final double seconds;
    private final Influences influences = new Influences();
    private final Vector3d centre = new Vector3d();

    BodiesTick(BodyTable table, Spaces spaces, double seconds) {
        bodies = table.size();
        step = new RigidStep(table, GRAVITY);
        this.spaces = spaces;
        this.seconds = seconds;
    }

    /**
     * @param walked the player has moved in it, the bodies not yet
     * @param drive of what is held, {@code null} for nothing
     */
    SimState step(SimState walked, BodyState drive) {
        if (bodies == 0) {
            return walked;
        }
        Changeable around = walked.around();
        influences.clearDriven();
        influences.clearPassing();
        if (around.holding().isHolding()) {
            influences.passCharacters(around.holding().body());
        }
        if (drive != null) {
            influences.drive(around.holding().body(), drive.velocity(), drive.spin());
        }
        meet(walked.player());
        Bodies moved = step.step(around.bodies(), spaces.of(around.portals()), influences, seconds);
        return walked.with(around.with(moved));
    }

    private void meet(PlayerState player) {
        influences.clearCharacters();
        Influences.Character body =
                influences.add(PlayerBody.RADIUS, player.stance().heightMetres(), PlayerBody.MASS_KILOGRAMS);
        body.move(PlayerEye.centre(player, centre), player.velocity().toVector());
    }
}
