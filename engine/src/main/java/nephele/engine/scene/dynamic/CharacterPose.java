package nephele.engine.scene.dynamic;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.scene.FrameState.Posture;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The position and orientation of each part of the character in a posture. The head is fixed at the eye; the body hangs
 * below it, and the legs reach the feet (two bones and the law of cosines), which {@link Gait} places. One object
 * serves all frames.
 */
final class CharacterPose {
    private static final double LOWEST_METRES = 0.9;
    private static final double HIGHEST_METRES = 2.2;
    private static final double QUICKEST_STRIDE = 3;
    private static final double FULL_TURN_RADIANS = 2 * Math.PI;

    /** The dimensions of the standing character, metres. */
    private static final double STATURE_METRES = 1.8;

    private static final double HEAD_BELOW_CROWN_METRES = 0.165;
    private static final double HEAD_TO_CHEST_METRES = 0.3;
    private static final double HEAD_TO_HIPS_METRES = 0.7;
    private static final double HALF_HIPS_METRES = 0.09;
    private static final double HALF_SHOULDERS_METRES = 0.205;
    private static final double SHOULDER_ABOVE_CHEST_METRES = 0.1;
    private static final double THIGH_METRES = 0.43;
    private static final double SHIN_METRES = 0.41;
    private static final double ANKLE_METRES = 0.09;
    /** The distance of the ball from the ankle, about which the foot turns. */
    private static final double BALL_METRES = 0.11;

    private static final double UPPER_ARM_METRES = 0.29;
    private static final double FOREARM_METRES = 0.26;
    private static final double MAX_LIFT_METRES = 0.16;

    private final Vector3d[] centres = new Vector3d[CharacterPart.ALL.length];
    private final Quaterniond[] turns = new Quaterniond[CharacterPart.ALL.length];
    private final Matrix3d worldFromCharacter = new Matrix3d();
    private final Vector3d sole = new Vector3d();
    private final Vector3d head = new Vector3d();
    private final Vector3d hips = new Vector3d();
    private final Vector3d[] ankles = {new Vector3d(), new Vector3d()};
    private final double[] footPitch = new double[2];
    private final Vector3d joint = new Vector3d();
    private final Vector3d shoulders = new Vector3d();

    /** The joint between a limb's two bones. */
    private final Vector3d middle = new Vector3d();

    /** The end of a limb: the reachable point nearest to its target. */
    private final Vector3d end = new Vector3d();

    /** The direction towards which a limb bends; set before {@link #bend(Vector3d, Vector3d, double, double)}. */
    private final Vector3d bend = new Vector3d();

    private final Vector3d along = new Vector3d();
    private final Vector3d across = new Vector3d();
    private final Vector3d front = new Vector3d();
    private final Vector3d halfway = new Vector3d();
    private final Matrix3d chest = new Matrix3d();
    private final Matrix3d pelvis = new Matrix3d();
    private final Matrix3d turn = new Matrix3d();
    private final Matrix3d inWorld = new Matrix3d();

    CharacterPose() {
        for (int i = 0; i < centres.length; i++) {
            centres[i] = new Vector3d();
            turns[i] = new Quaterniond();
        }
    }

    /** Returns the world position of a part's origin, valid until the next {@link #compute}. */
    Vector3d centre(CharacterPart part) {
        return centres[part.ordinal()];
    }

    /** Returns the rotation from a part's frame to the world. */
    Quaterniond orientation(CharacterPart part) {
        return turns[part.ordinal()];
    }

    /**
     * Computes the pose.
     *
     * @param seconds time that drives the breathing
     */
    void compute(Posture posture, double seconds) {
        Posture p = sane(posture);
        place(p);
        double crouch = Math.max(0, Math.min(1, (STATURE_METRES - p.heightMetres()) / 0.7));
        double moving = Gait.smooth(p.stride() / 0.3);
        double lean = 0.55 * crouch + 0.1 * Math.min(1.6, p.stride()) * Math.cos(p.travelRadians());
        double folded = folded(p.travelRadians());
        pelvis.rotationY(0.55 * folded * moving).rotateX(-0.6 * lean);
        head.set(0, p.heightMetres() - HEAD_BELOW_CROWN_METRES, 0);
        hips.set(0, -HEAD_TO_HIPS_METRES, 0).rotateX(-lean).add(head);
        hips.z += bowed(p) / 2 - 0.25 * HEAD_TO_HIPS_METRES * Math.sin(lean);
        feet(p, 0.7 * folded * moving, moving);
        reachFeet();
        for (int side = 0; side < 2; side++) {
            leg(side, 0.7 * folded * moving);
        }
        double breath = Math.sin(seconds * Math.PI / 2.1);
        torso(p, lean, folded * moving, breath);
        for (int side = 0; side < 2; side++) {
            arm(p, side, moving, breath);
        }
        joint.set(head);
        turn.rotationX(p.pitchRadians() * 0.85);
        put(CharacterPart.HEAD, joint, turn);
    }

    /** Returns the metres by which the head is in front of the body, so that looking down shows the legs. */
    private static double bowed(Posture p) {
        return 0.15 * Math.max(0, -Math.sin(p.pitchRadians()));
    }

    /**
     * Returns the direction in which the legs walk, at most a quarter turn aside: greater angles are walked backwards.
     */
    private static double folded(double travel) {
        return Math.abs(travel) <= Math.PI / 2 ? travel : travel - Math.copySign(Math.PI, travel);
    }

    private void place(Posture p) {
        double sin = StrictMath.sin(p.yawRadians());
        double cos = StrictMath.cos(p.yawRadians());
        worldFromCharacter.set(cos, 0, -sin, 0, 1, 0, sin, 0, cos);
        worldFromCharacter.rotateLocal(Posture.leaning(p.up()));
        sole.set(p.centre().x(), p.centre().y(), p.centre().z());
        sole.fma(-p.heightMetres() / 2, worldFromCharacter.getColumn(1, along));
    }

    /** Computes the target positions of both ankles, on the ground or in the air. */
    private void feet(Posture p, double footYaw, double moving) {
        double amplitude = Gait.smooth(p.stride() / 0.25) * MAX_LIFT_METRES * (0.55 + 0.45 * Math.min(1.5, p.stride()));
        double forward = Math.cos(p.travelRadians());
        for (int side = 0; side < 2; side++) {
            double out = side == 0 ? -1 : 1;
            Gait.Foot foot = Gait.foot((p.step() + 0.5 * side) % 1, p.stride());
            double ahead = foot.along();
            double pitch = foot.pitch() * moving * forward * 0.85;
            double wide = HALF_HIPS_METRES + 0.02 - 0.035 * moving * Math.abs(forward);
            Vector3d ankle = ankles[side];
            // The ball stays in place while the heel rises.
            double back = BALL_METRES * Math.cos(pitch) - ANKLE_METRES * Math.sin(pitch) - BALL_METRES;
            double rise = BALL_METRES * Math.sin(pitch) + ANKLE_METRES * Math.cos(pitch);
            ankle.set(0, Math.max(rise, ANKLE_METRES * Math.cos(pitch)), pitch > 0 ? back : 0);
            ankle.rotateY(footYaw);
            ankle.add(-Math.sin(p.travelRadians()) * ahead, foot.lift() * amplitude, -forward * ahead);
            ankle.x += out * wide * Math.cos(footYaw);
            ankle.z -= out * wide * Math.sin(footYaw);
            footPitch[side] = pitch;
            fly(p, side, wide);
        }
    }

    private void fly(Posture p, int side, double wide) {
        double air = p.airborne();
        if (air <= 0) {
            return;
        }
        double out = side == 0 ? -1 : 1;
        end.set(out * (wide + 0.03), side == 0 ? 0.3 : 0.2, side == 0 ? -0.14 : 0.2);
        ankles[side].lerp(end, air);
        footPitch[side] += air * ((side == 0 ? 0.25 : 0.7) - footPitch[side]);
    }

    /** Lowers the hips until the farther foot is within reach. */
    private void reachFeet() {
        double longest = THIGH_METRES + SHIN_METRES - 0.012;
        double lowest = hips.y;
        for (int side = 0; side < 2; side++) {
            hip(side, joint);
            double x = joint.x - ankles[side].x;
            double z = joint.z - ankles[side].z;
            double upright = Math.sqrt(Math.max(0, longest * longest - x * x - z * z));
            lowest = Math.min(lowest, hips.y + ankles[side].y + upright - joint.y);
        }
        hips.y = lowest;
    }

    private Vector3d hip(int side, Vector3d out) {
        out.set(side == 0 ? -HALF_HIPS_METRES : HALF_HIPS_METRES, -0.03, 0);
        return pelvis.transform(out).add(hips);
    }

    private void leg(int side, double footYaw) {
        hip(side, joint);
        bend.set(side == 0 ? -0.12 : 0.12, 0, -1).rotateY(footYaw);
        bend(joint, ankles[side], THIGH_METRES, SHIN_METRES);
        bone(side == 0 ? CharacterPart.LEFT_THIGH : CharacterPart.RIGHT_THIGH, joint, middle);
        bone(side == 0 ? CharacterPart.LEFT_SHIN : CharacterPart.RIGHT_SHIN, middle, end);
        turn.rotationY(footYaw).rotateX(-footPitch[side]);
        put(side == 0 ? CharacterPart.LEFT_FOOT : CharacterPart.RIGHT_FOOT, end, turn);
    }

    private void torso(Posture p, double lean, double travel, double breath) {
        joint.set(0, 0.02, 0);
        pelvis.transform(joint).add(hips);
        put(CharacterPart.PELVIS, joint, pelvis);
        double swing = Math.sin(2 * Math.PI * p.step()) * 0.12 * Math.min(1, p.stride()) * Math.cos(p.travelRadians());
        chest.rotationY(0.2 * travel + swing).rotateX(-lean - 0.012 * breath);
        // Between head and hips, nearer to the head.
        double fraction = HEAD_TO_CHEST_METRES / HEAD_TO_HIPS_METRES;
        joint.set(head).lerp(hips, fraction);
        joint.y += 0.004 * breath - 0.25 * fraction * (HEAD_TO_HIPS_METRES - head.distance(hips));
        joint.z += 0.02 * Math.sin(lean) + bowed(p) * (1 - fraction / 2);
        put(CharacterPart.CHEST, joint, chest);
        end.set(joint);
        shoulders.set(joint);
    }

    private void arm(Posture p, int side, double moving, double breath) {
        double out = side == 0 ? -1 : 1;
        double opposite = Math.sin(2 * Math.PI * (p.step() + 0.5 * side) + 0.5 * Math.PI);
        double quick = Math.min(1.5, p.stride());
        double carry = p.carrying();
        double air = p.airborne() * (1 - carry);
        double swing = -opposite * (0.25 + 0.4 * quick) * moving * Math.cos(p.travelRadians());
        double raise = mix(swing + 0.04, 0.95, carry) * (1 - air) + air * (side == 0 ? 0.5 : -0.3);
        double spread = mix(0.13 + 0.05 * moving, 0.02, carry) * (1 - air) + air * 0.75;
        double low = Math.max(0, Math.min(1, (STATURE_METRES - p.heightMetres()) / 0.7));
        raise += 0.5 * low * (1 - carry);
        double elbow = mix(0.22 + 0.9 * low + moving * (0.45 * quick + 0.3 * Math.max(0, -opposite)), 0.55, carry);
        spread += 0.008 * breath;
        joint.set(out * HALF_SHOULDERS_METRES, SHOULDER_ABOVE_CHEST_METRES, 0);
        chest.transform(joint).add(shoulders);
        along.set(0, -1, 0).rotateZ(out * spread).rotateX(raise);
        chest.transform(along);
        middle.set(joint).fma(UPPER_ARM_METRES, along);
        end.set(0, -1, 0).rotateZ(out * spread * mix(0.6, -6, carry)).rotateX(raise + elbow * (1 - air * 0.4));
        chest.transform(end);
        end.mul(FOREARM_METRES).add(middle);
        bend.set(0, 0, 1);
        chest.transform(bend);
        bone(side == 0 ? CharacterPart.LEFT_UPPER_ARM : CharacterPart.RIGHT_UPPER_ARM, joint, middle);
        bone(side == 0 ? CharacterPart.LEFT_FOREARM : CharacterPart.RIGHT_FOREARM, middle, end);
    }

    private static double mix(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }

    /** Places a part's centre halfway between two joints, with its front on the side opposite to the limb's bend. */
    private void bone(CharacterPart part, Vector3d from, Vector3d to) {
        orient(from, to, part.ordinal() >= CharacterPart.LEFT_THIGH.ordinal(), turn);
        put(part, halfway.set(from).lerp(to, 0.5), turn);
    }

    /**
     * Computes {@link #middle} and {@link #end} of a limb of two bones from {@code from} towards {@code to}, by the law of
     * cosines; lengths in metres.
     */
    private void bend(Vector3d from, Vector3d to, double upper, double lower) {
        along.set(to).sub(from);
        double distance = Math.max(Math.abs(upper - lower) + 0.05, Math.min(upper + lower - 0.002, along.length()));
        if (along.length() < 1e-6) {
            along.set(0, -1, 0);
        }
        along.normalize();
        end.set(from).fma(distance, along);
        bend.fma(-bend.dot(along), along);
        if (bend.length() < 1e-6) {
            bend.set(0, 0, -1).fma(along.z, along);
        }
        bend.normalize();
        double before = (upper * upper - lower * lower + distance * distance) / (2 * distance);
        double aside = Math.sqrt(Math.max(0, upper * upper - before * before));
        middle.set(from).fma(before, along).fma(aside, bend);
    }

    /** Computes the rotation of a bone from one joint down to the other; a leg's front is on the side of the bend. */
    private void orient(Vector3d from, Vector3d to, boolean isLeg, Matrix3d turn) {
        Vector3d y = along.set(from).sub(to).normalize();
        Vector3d z = front.set(bend).mul(isLeg ? -1 : 1);
        z.fma(-z.dot(y), y);
        if (z.length() < 1e-6) {
            z.set(0, 0, 1).fma(-y.z, y);
        }
        z.normalize();
        Vector3d x = y.cross(z, across);
        turn.set(x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z);
    }

    private void put(CharacterPart part, Vector3d inCharacter, Matrix3d characterFromPart) {
        worldFromCharacter.transform(inCharacter, centres[part.ordinal()]).add(sole);
        worldFromCharacter.mul(characterFromPart, inWorld);
        turns[part.ordinal()].setFromNormalized(inWorld).normalize();
    }

    private static Posture sane(Posture p) {
        Vec3 up = Directions.unit(p.up());
        return new Posture(
                new Vec3(
                        finite(p.centre().x()),
                        finite(p.centre().y()),
                        finite(p.centre().z())),
                up == null ? new Vec3(0, 1, 0) : up,
                finite(p.yawRadians()) % FULL_TURN_RADIANS,
                within(p.pitchRadians(), -Math.PI / 2, Math.PI / 2),
                within(p.heightMetres(), LOWEST_METRES, HIGHEST_METRES),
                finite(p.step()) - Math.floor(finite(p.step())),
                within(p.stride(), 0, QUICKEST_STRIDE),
                Math.IEEEremainder(finite(p.travelRadians()), FULL_TURN_RADIANS),
                within(p.airborne(), 0, 1),
                within(p.carrying(), 0, 1));
    }

    private static double finite(double x) {
        return Double.isFinite(x) ? x : 0;
    }

    private static double within(double x, double least, double most) {
        return Double.isNaN(x) ? Math.max(least, Math.min(most, 0)) : Math.max(least, Math.min(most, x));
    }
}
