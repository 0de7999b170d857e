package nephele.engine.sim;

import static nephele.engine.sim.PlayerBody.GRAVITY;
import static nephele.engine.sim.PlayerBody.STEEPEST_GROUND_UP;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Recovery;
import nephele.engine.collision.RoundedHull;
import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerBody.Stance;
import org.joml.Vector3d;

/** One tick of the player: look, stand or crouch, jump, walk or fly. The working set of one simulation. */
final class PlayerStep {
    /** Slower than this is at rest: the exponential would go on for ever. */
    private static final double AT_REST_SPEED = 1e-4;

    private static final double HEAD_RADIUS = 0.1;
    private static final RoundedHull HEAD = RoundedHull.sphere(HEAD_RADIUS);

    private final CollisionWorld world;
    private final double seconds;
    private final Damping groundDamping;
    private final Damping eyeDamping;
    private final Mover mover = new Mover();
    private final GroundWalk walk = new GroundWalk(mover);
    private final Recovery recovery = new Recovery();
    private final Vector3d place = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d wish = new Vector3d();
    private final Vector3d way = new Vector3d();
    private final Vector3d ground = new Vector3d();
    private final Vector3d head = new Vector3d();
    private boolean grounded;
    private double centreBefore;
    private double eye;
    private Stance stance;

    PlayerStep(CollisionWorld world, double seconds) {
        this.world = world;
        this.seconds = seconds;
        groundDamping = Damping.of(PlayerBody.GROUND_RATE_PER_SECOND, seconds);
        eyeDamping = Damping.of(PlayerBody.EYE_RATE_PER_SECOND, seconds);
        mover.enter(world);
    }

    PlayerState step(PlayerState before, PlayerInput input) {
        Heading heading = before.heading().turned(input.turnLeftMillidegrees(), input.turnUpMillidegrees());
        load(before);
        changeStance(input.holds(Action.CROUCH));
        if (recover()) {
            settle();
            wishFor(heading, input);
            if (grounded && world.size() > 0 && input.holds(Action.JUMP) && !before.jumpHeld()) {
                jump();
            }
            if (grounded) {
                walkOnGround();
            } else {
                fly();
            }
        }
        eye = eyeDamping.approach(eye, stance.eyeMetres());
        return store(before.feet().y(), heading, input.holds(Action.JUMP));
    }

    private void load(PlayerState s) {
        stance = s.stance();
        place.set(
                s.feet().x(), s.feet().y() + stance.centreAboveFeet(), s.feet().z());
        centreBefore = place.y;
        velocity.set(s.velocity().x(), s.velocity().y(), s.velocity().z());
        eye = s.eyeMetres();
        // Whatever throws a player upwards lifts it off the ground.
        grounded = s.isGrounded() && velocity.y <= 0;
        if (grounded) {
            ground.set(s.ground().x(), s.ground().y(), s.ground().z());
        } else if (world.size() == 0) {
            // Nothing to fall onto: the player hovers.
            grounded = true;
            ground.set(0, 1, 0);
        }
    }

    /** Adds the rise to the feet's old height: to and fro between feet and centre, rounding would creep. */
    private PlayerState store(double feetBefore, Heading heading, boolean jumpHeld) {
        Vec3 feet = new Vec3(place.x, feetBefore + (place.y - centreBefore), place.z);
        Vec3 speed = new Vec3(velocity.x, velocity.y, velocity.z);
        Vec3 normal = grounded ? new Vec3(ground.x, ground.y, ground.z) : null;
        return new PlayerState(feet, speed, heading, eye, stance, normal, jumpHeld);
    }

    /** Feet stay where they are; standing up waits for head room: the low capsule swept upwards is the high one. */
    private void changeStance(boolean wantsCrouch) {
        Stance wanted = wantsCrouch ? Stance.CROUCHED : Stance.STANDING;
        if (wanted == stance) {
            return;
        }
        way.set(0, wanted.heightMetres() - stance.heightMetres(), 0);
        if (wantsCrouch || !mover.isBlocked(stance.shape(), place, way)) {
            place.y += wanted.centreAboveFeet() - stance.centreAboveFeet();
            centreBefore = place.y;
            stance = wanted;
        }
    }

    /** Pushes a player out of solids, a little each tick; false while it is still inside. */
    private boolean recover() {
        recovery.find(world, stance.shape(), place, way);
        double needed = way.length();
        if (needed == 0) {
            return true;
        }
        double pushed = Math.min(needed, PlayerBody.RECOVERY_METRES_PER_TICK);
        place.add(way.mul(pushed / needed));
        if (pushed < needed) {
            velocity.zero();
            grounded = false;
            return false;
        }
        return true;
    }

    /** Who is put onto ground stands on it at once. */
    private void settle() {
        if (!grounded && velocity.y == 0 && walk.land(stance.shape(), place)) {
            grounded = true;
            ground.set(walk.ground());
        }
    }

    /** The horizontal velocity that is asked for. */
    private void wishFor(Heading heading, PlayerInput input) {
        double sin = StrictMath.sin(heading.yawRadians());
        double cos = StrictMath.cos(heading.yawRadians());
        double forward = input.forwardPercent() / 100.0;
        double right = input.rightPercent() / 100.0;
        wish.set(right * cos - forward * sin, 0, -right * sin - forward * cos);
        double length = wish.length();
        wish.mul(speed(input) / Math.max(1, length));
    }

    private double speed(PlayerInput input) {
        if (stance == Stance.CROUCHED) {
            return PlayerBody.CROUCH_SPEED;
        }
        return input.holds(Action.RUN) ? PlayerBody.RUN_SPEED : PlayerBody.WALK_SPEED;
    }

    /** With the speed whose ballistic apex is exactly the jump's height. */
    private void jump() {
        velocity.y = Math.sqrt(2 * GRAVITY * PlayerBody.JUMP_HEIGHT);
        grounded = false;
    }

    private void walkOnGround() {
        way.set(groundDamping.way(velocity.x, wish.x), 0, groundDamping.way(velocity.z, wish.z));
        velocity.set(groundDamping.approach(velocity.x, wish.x), 0, groundDamping.approach(velocity.z, wish.z));
        if (wish.lengthSquared() == 0 && velocity.length() < AT_REST_SPEED) {
            velocity.zero();
            way.zero();
        }
        double height = place.y;
        double slope = -(ground.x * way.x + ground.z * way.z) / ground.y;
        grounded = walk.walk(stance.shape(), place, way, ground);
        ground.set(walk.ground());
        walk.walls().clip(velocity);
        smoothEye(place.y - height - slope);
    }

    /** The eye stays behind where the feet jump up or down a step, but in the body or, going down, in free air above. */
    private void smoothEye(double suddenRise) {
        eye = Math.max(PlayerBody.RADIUS, eye - suddenRise);
        double inHead = stance.heightMetres() - HEAD_RADIUS;
        if (eye > inHead) {
            way.set(0, eye - inHead, 0);
            head.set(place.x, place.y - stance.centreAboveFeet() + inHead, place.z);
            mover.isBlocked(HEAD, head, way);
            eye = inHead + mover.lastSweep().fraction() * way.y;
        }
    }

    /** The exact ballistic way of the tick: v t − g t² / 2 (velocity Verlet under constant acceleration). */
    private void fly() {
        way.set(velocity).mul(seconds);
        steerInAir();
        way.y -= GRAVITY * seconds * seconds / 2;
        velocity.y -= GRAVITY * seconds;
        double fall = way.y;
        double heightBefore = place.y;
        double vX = velocity.x;
        double vZ = velocity.z;
        mover.slide(stance.shape(), place, way);
        mover.planes().clip(velocity);
        boolean wedged = fall < 0 && mover.planes().size() >= 2 && place.y - heightBefore > fall / 100;
        if (fall < 0 && walk.land(stance.shape(), place)) {
            touchDown(vX, vZ);
        } else if (wedged) {
            ground.set(0, 1, 0);
            grounded = true;
            velocity.y = 0;
        }
    }

    /** Slopes that carry do not push: the horizontal speed stays, but for steep surfaces met in the same tick. */
    private void touchDown(double vX, double vZ) {
        grounded = true;
        ground.set(walk.ground());
        velocity.set(vX, 0, vZ);
        for (int i = 0; i < mover.planes().size(); i++) {
            double into = velocity.dot(mover.planes().normal(i));
            if (mover.planes().normal(i).y() < STEEPEST_GROUND_UP && into < 0) {
                velocity.sub(way.set(mover.planes().normal(i)).mul(into));
            }
        }
        velocity.y = 0;
    }

    /** Adds speed only as far as the wish goes and never beyond what was flown already; lets go of nothing. */
    private void steerInAir() {
        double wished = wish.length();
        if (wished == 0) {
            return;
        }
        double along = (velocity.x * wish.x + velocity.z * wish.z) / wished;
        double gain = Math.min(PlayerBody.AIR_ACCELERATION * seconds, wished - along);
        if (gain <= 0) {
            return;
        }
        double before = Math.sqrt(velocity.x * velocity.x + velocity.z * velocity.z);
        double x = velocity.x + wish.x / wished * gain;
        double z = velocity.z + wish.z / wished * gain;
        double limit = Math.max(before, wished);
        double scale = Math.min(1, limit / Math.sqrt(x * x + z * z));
        way.x += (x * scale - velocity.x) * seconds / 2;
        way.z += (z * scale - velocity.z) * seconds / 2;
        velocity.x = x * scale;
        velocity.z = z * scale;
    }
}
