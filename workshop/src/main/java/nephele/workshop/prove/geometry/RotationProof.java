package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.sim.player.MouseLook;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.ViewAngles;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Quaterniond;

/** Rotates views by any mouse input, and interpolates any pair of rotations. */
public final class RotationProof implements Proof {
    private static final double DEGREES_PER_COUNT = 0.126;

    @Override
    public Claim claim() {
        return new Claim(
                "rotations",
                "A view never turns farther than the mouse input; interpolation between any two rotations"
                        + " gives a unit rotation at the proportional angle.",
                "turns",
                1_000_000,
                250_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        List<String> failures = new ArrayList<>();
        double worstNorm = 0;
        for (long unit = from; unit < from + count; unit++) {
            var random = new SplittableRandom(unit);
            turn(unit, random, failures);
            worstNorm = Math.max(worstNorm, interpolate(unit, random, failures));
            progress.unitsDone(unit + 1 - from);
        }
        return ProofResult.of(count, failures, Figure.greatest("length of a rotation off 1", worstNorm, ""));
    }

    /** Converts mouse counts to whole millidegrees, and these to view angles, as the game does. */
    private static void turn(long unit, SplittableRandom random, List<String> failures) {
        int counts = unit % 100 == 0 ? 1_000_000 : 40;
        double right = random.nextInt(-counts, counts + 1);
        double down = random.nextInt(-counts, counts + 1);
        PlayerInput input = new MouseLook(DEGREES_PER_COUNT).turn(PlayerInput.NONE, right, down);
        int left = input.turnLeftMillidegrees();
        int up = input.turnUpMillidegrees();
        var look = new ViewAngles(random.nextInt(-400_000, 400_000), random.nextInt(-100_000, 100_000));
        ViewAngles next = look.turned(left, up);
        boolean asked = Math.abs(left) <= Math.abs(right) * DEGREES_PER_COUNT * 1000 + 1e-6
                && Math.abs(up) <= Math.abs(down) * DEGREES_PER_COUNT * 1000 + 1e-6;
        boolean wrapped = next.yawRadians() >= -Math.PI && next.yawRadians() < Math.PI;
        boolean upright = Math.abs(next.pitchMillidegrees()) <= 89_900;
        int lost = next.yawMillidegrees() - look.yawMillidegrees() - left;
        boolean exact =
                lost % 360_000 == 0 && Math.abs(next.pitchMillidegrees() - look.pitchMillidegrees()) <= Math.abs(up);
        double most = Math.toRadians((Math.abs((double) left) + Math.abs((double) up)) / 1000);
        if (!asked || !wrapped || !upright || !exact || !(Directions.angle(back(look), back(next)) <= most + 1e-9)) {
            failures.add("turn " + unit + ": from " + look + " to " + next);
        }
    }

    private static Vec3 back(ViewAngles heading) {
        return Basis.ofYawPitch(heading.yawRadians(), heading.pitchRadians()).back();
    }

    /** Returns the difference of the result's length from 1. */
    private static double interpolate(long unit, SplittableRandom random, List<String> failures) {
        Quaterniond a = rotation(random, random.nextDouble(-7, 7));
        Quaterniond b = partner(random, a, (int) (unit % 6));
        double fraction = unit % 9 == 0 ? random.nextDouble(-5, 5) : random.nextDouble();
        Quaterniond q = Rotations.slerp(a, b, fraction);
        double off = Math.abs(Math.sqrt(q.lengthSquared()) - 1);
        double whole = angle(a, b);
        double wanted = Math.max(0, Math.min(1, fraction)) * whole;
        if (!(off <= 1e-6) || !(Math.abs(angle(a, q) - wanted) <= 1e-6 * (1 + whole))) {
            failures.add("turn " + unit + ": " + q + " between " + a + " and " + b);
        }
        return off;
    }

    private static Quaterniond rotation(SplittableRandom random, double radians) {
        var axis = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        return Rotations.aroundAxis(axis, radians);
    }

    /** Returns an equal rotation, one opposite in sign, half a turn away, hardly different, or any. */
    private static Quaterniond partner(SplittableRandom random, Quaterniond a, int kind) {
        return switch (kind) {
            case 0 -> new Quaterniond(a);
            case 1 -> new Quaterniond(-a.x, -a.y, -a.z, -a.w);
            case 2 -> new Quaterniond(a).mul(rotation(random, Math.PI));
            case 3 -> new Quaterniond(a).mul(rotation(random, random.nextDouble(-2e-3, 2e-3)));
            default -> rotation(random, random.nextDouble(-7, 7));
        };
    }

    /** Returns the angle of the rotation from a to b, 0 to π. */
    private static double angle(Quaterniond a, Quaterniond b) {
        Quaterniond d = new Quaterniond(a).conjugate().mul(b);
        return 2 * Math.atan2(Math.sqrt(d.x * d.x + d.y * d.y + d.z * d.z), Math.abs(d.w));
    }
}
