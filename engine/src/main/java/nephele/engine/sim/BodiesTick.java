package nephele.engine.sim;

import nephele.engine.collision.Sweep;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.math.Vec3;
import nephele.engine.sim.player.BodyPushes;
import nephele.engine.sim.player.PlayerEye;
import nephele.engine.sim.state.FaultLog;
import nephele.engine.sim.state.HeldBody;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.PortalWorldCache;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Steps all bodies by one tick: they collide with the player's capsule and each other, and the held body is driven. */
final class BodiesTick {
    /** In m/s. A player that is pushed upwards faster than this leaves the ground. */
    private static final double LIFTING_METRES_PER_SECOND = 0.5;

    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);

    private final int bodies;
    private final RigidStep step;
    private final FaultLog faults;
    private final PortalWorldCache worlds;
    private final double seconds;
    private final BodyInfluences influences = new BodyInfluences();
    private final BodyInfluences.Character standing = character(PlayerDimensions.Stance.STANDING);
    private final BodyInfluences.Character crouched = character(PlayerDimensions.Stance.CROUCHED);
    private final Vector3d centre = new Vector3d();
    private final Vector3d velocity = new Vector3d();

    BodiesTick(BodyTable table, PortalWorldCache worlds, double seconds, FaultLog faults) {
        this.faults = faults;
        bodies = table.size();
        step = new RigidStep(table, GRAVITY);
        this.worlds = worlds;
        this.seconds = seconds;
    }

    /**
     * Returns the player's capsule, enlarged by the skin that its own sweeps keep from obstacles, so that it touches
     * bodies there.
     */
    private static BodyInfluences.Character character(PlayerDimensions.Stance stance) {
        double skin = Sweep.SKIN_METRES;
        return new BodyInfluences.Character(
                PlayerDimensions.RADIUS_METRES + skin,
                stance.heightMetres() + 2 * skin,
                PlayerDimensions.MASS_KILOGRAMS);
    }

    /**
     * @param walked the state in which the player has moved and the bodies have not
     * @param pushes the player's contacts with bodies, and its push on them
     * @param drive the motion of the held body, {@code null} for none
     */
    SimState step(SimState walked, BodyPushes pushes, BodyState drive) {
        if (bodies == 0) {
            return walked;
        }
        WorldState around = walked.world();
        influences.clearDriven();
        influences.clearPassing();
        if (around.holding().passing() != HeldBody.NONE) {
            influences.ignoreCharacters(around.holding().passing());
        }
        if (drive != null) {
            influences.drive(around.holding().body(), drive.velocity(), drive.spin());
        }
        BodyInfluences.Character player = placeCharacter(walked.player(), pushes);
        Bodies moved = step.step(around.bodies(), worlds.of(around.portals()), influences, seconds);
        int faulty = moved.frozen() - around.bodies().frozen() + step.cutShort();
        if (faulty > 0) {
            faults.fault(walked.tick(), faulty + " bodies frozen, or past their portals of a tick");
        }
        return walked.withPlayer(shoved(walked.player(), player.impulse(), pushes.push()))
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
        impulse.div(PlayerDimensions.MASS_KILOGRAMS, velocity).add(push);
        boolean stays = player.isGrounded() && velocity.y < LIFTING_METRES_PER_SECOND;
        Vec3 own = player.velocity();
        return player.shoved(
                new Vec3(own.x() + velocity.x, own.y() + (stays ? 0 : velocity.y), own.z() + velocity.z), stays);
    }

    /**
     * Sets the player's capsule for the step. Without contacts it starts where the player's tick began, so that both
     * move at the same time; in contact it starts where the player is and pushes from there.
     */
    private BodyInfluences.Character placeCharacter(PlayerState player, BodyPushes pushes) {
        influences.clearCharacters();
        BodyInfluences.Character body = player.stance() == PlayerDimensions.Stance.STANDING ? standing : crouched;
        influences.add(body);
        Vec3 own = player.velocity();
        velocity.set(own.x(), own.y(), own.z());
        PlayerEye.centre(player, centre).fma(pushes.isTouching() ? 0 : -seconds, velocity);
        body.move(centre, velocity.add(pushes.push()));
        return body;
    }
}
