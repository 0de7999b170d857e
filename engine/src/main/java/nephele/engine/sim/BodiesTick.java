package nephele.engine.sim;

import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.Bodies;
import nephele.engine.collision.rigid.BodyState;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.collision.rigid.Influences;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Steps all bodies by one tick: they collide with the player's capsule and each other, and the held body is driven. */
final class BodiesTick {
    /** In m/s. A player that is pushed upwards faster than this leaves the ground. */
    private static final double LIFTING_SPEED = 0.5;

    private static final Vec3 GRAVITY = new Vec3(0, -PlayerBody.GRAVITY, 0);

    private final int bodies;
    private final RigidStep step;
    private final FaultLog faults;
    private final Spaces spaces;
    private final double seconds;
    private final Influences influences = new Influences();
    private final Influences.Character standing = character(PlayerBody.Stance.STANDING);
    private final Influences.Character crouched = character(PlayerBody.Stance.CROUCHED);
    private final Vector3d centre = new Vector3d();
    private final Vector3d velocity = new Vector3d();

    BodiesTick(BodyTable table, Spaces spaces, double seconds, FaultLog faults) {
        this.faults = faults;
        bodies = table.size();
        step = new RigidStep(table, GRAVITY);
        this.spaces = spaces;
        this.seconds = seconds;
    }

    /**
     * Returns the player's capsule, enlarged by the skin that its own sweeps keep from obstacles, so that it touches
     * bodies there.
     */
    private static Influences.Character character(PlayerBody.Stance stance) {
        double skin = Sweep.SKIN_METRES;
        return new Influences.Character(
                PlayerBody.RADIUS + skin, stance.heightMetres() + 2 * skin, PlayerBody.MASS_KILOGRAMS);
    }

    /**
     * @param walked the state in which the player has moved and the bodies have not
     * @param shoves the player's contacts with bodies, and its push on them
     * @param drive the motion of the held body, {@code null} for none
     */
    SimState step(SimState walked, Shoves shoves, BodyState drive) {
        if (bodies == 0) {
            return walked;
        }
        Changeable around = walked.around();
        influences.clearDriven();
        influences.clearPassing();
        if (around.holding().passing() != Holding.NONE) {
            influences.passCharacters(around.holding().passing());
        }
        if (drive != null) {
            influences.drive(around.holding().body(), drive.velocity(), drive.spin());
        }
        Influences.Character player = meet(walked.player(), shoves);
        Bodies moved = step.step(around.bodies(), spaces.of(around.portals()), influences, seconds);
        int faulty = moved.frozen() - around.bodies().frozen() + step.cutShort();
        if (faulty > 0) {
            faults.fault(walked.tick(), faulty + " bodies frozen, or past their portals of a tick");
        }
        return walked.withPlayer(shoved(walked.player(), player.impulse(), shoves.push()))
                .withFaults(walked.faults() + Math.max(0, faulty))
                .with(around.with(moved));
    }

    /**
     * Adds the velocity change that the bodies gave the player. The player's own push is taken out of it, as the ground
     * bears its reaction.
     */
    private PlayerState shoved(PlayerState player, Vector3dc impulse, Vector3dc push) {
        if (impulse.lengthSquared() == 0) {
            return player;
        }
        impulse.div(PlayerBody.MASS_KILOGRAMS, velocity).add(push);
        boolean stays = player.isGrounded() && velocity.y < LIFTING_SPEED;
        Vec3 own = player.velocity();
        return player.shoved(
                new Vec3(own.x() + velocity.x, own.y() + (stays ? 0 : velocity.y), own.z() + velocity.z), stays);
    }

    /**
     * Sets the player's capsule for the step. Without contacts it starts where the player's tick began, so that both
     * move at the same time; in contact it starts where the player is and pushes from there.
     */
    private Influences.Character meet(PlayerState player, Shoves shoves) {
        influences.clearCharacters();
        Influences.Character body = player.stance() == PlayerBody.Stance.STANDING ? standing : crouched;
        influences.add(body);
        Vec3 own = player.velocity();
        velocity.set(own.x(), own.y(), own.z());
        PlayerEye.centre(player, centre).fma(shoves.isTouching() ? 0 : -seconds, velocity);
        body.move(centre, velocity.add(shoves.push()));
        return body;
    }
}
