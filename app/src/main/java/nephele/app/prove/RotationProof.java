package nephele.app.prove;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Directions;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.math.YawPitch;
import org.joml.Quaterniond;

/** Turns views by anything a mouse may say, and interpolates any pair of rotations. */
public final class RotationProof implements Proof {
    private static final double RADIANS_PER_COUNT = 0.0022;

    @Override
    public String name() {
        return "rotations";
    }

    @Override
    public String claim() {
        return "A view never turns farther than the mouse asks, and between any two rotations lies a unit one, in"
                + " proportion.";
    }

    @Override
    public String unit() {
        return "turns";
    }

    @Override
    public long fullCount() {
        return 1_000_000;
    }

    @Override
    public long batch() {
        return 250_000;
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        List<String> failures = new ArrayList<>();
        double worstNorm = 0;
        for (long unit = from; unit < from + count; unit++) {
            var random = new SplittableRandom(unit);
            turn(unit, random, failures);
            worstNorm = Math.max(worstNorm, interpolate(unit, random, failures));
            if (unit % 10_000 == 9999) {
                progress.unitsDone(unit + 1 - from);
            }
        }
        return new ProofResult(
                count,
                failures.size(),
                List.of(Figure.greatest("length of a rotation off 1", worstNorm, "")),
                failures);
    }

    private static void turn(long unit, SplittableRandom random, List<String> failures) {
        int counts = unit % 100 == 0 ? 1_000_000 : 40;
        double yaw = RADIANS_PER_COUNT * random.nextInt(-counts, counts + 1);
        double pitch = RADIANS_PER_COUNT * random.nextInt(-counts, counts + 1);
        var look = new YawPitch(random.nextDouble(-4, 4), random.nextDouble(-2, 2));
        YawPitch next = look.turned(yaw, pitch);
        boolean wrapped = next.yaw() >= -Math.PI && next.yaw() < Math.PI;
        boolean upright = Math.abs(next.pitch()) <= YawPitch.GREATEST_PITCH;
        double turned = Directions.angle(look.basis().back(), next.basis().back());
        double lost = YawPitch.wrapped(next.yaw() - look.yaw() - yaw);
        boolean exact = Math.abs(lost) <= 1e-9 * (1 + Math.abs(yaw));
        if (!wrapped || !upright || !exact || !(turned <= Math.abs(yaw) + Math.abs(pitch) + 1e-9)) {
            failures.add("turn " + unit + ": from " + look + " to " + next);
        }
    }

    /** Returns how far the result's length is from 1. */
    private static double interpolate(long unit, SplittableRandom random, List<String> failures) {
        Quaterniond a = rotation(random, random.nextDouble(-7, 7));
        Quaterniond b = partner(random, a, (int) (unit % 6));
        double share = unit % 9 == 0 ? random.nextDouble(-5, 5) : random.nextDouble();
        Quaterniond q = Rotations.slerp(a, b, share);
        double off = Math.abs(Math.sqrt(q.lengthSquared()) - 1);
        double whole = angle(a, b);
        double wanted = Math.max(0, Math.min(1, share)) * whole;
        if (!(off <= 1e-6) || !(Math.abs(angle(a, q) - wanted) <= 1e-6 * (1 + whole))) {
            failures.add("turn " + unit + ": " + q + " between " + a + " and " + b);
        }
        return off;
    }

    private static Quaterniond rotation(SplittableRandom random, double radians) {
        var axis = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
        return Rotations.aroundAxis(axis, radians);
    }

    /** Equal, opposite in sign, half a turn away, hardly different, or any. */
    private static Quaterniond partner(SplittableRandom random, Quaterniond a, int kind) {
        return switch (kind) {
            case 0 -> new Quaterniond(a);
            case 1 -> new Quaterniond(-a.x, -a.y, -a.z, -a.w);
            case 2 -> new Quaterniond(a).mul(rotation(random, Math.PI));
            case 3 -> new Quaterniond(a).mul(rotation(random, random.nextDouble(-2e-3, 2e-3)));
            default -> rotation(random, random.nextDouble(-7, 7));
        };
    }

    /** Of the rotation from a to b, 0 to π. */
    private static double angle(Quaterniond a, Quaterniond b) {
        Quaterniond d = new Quaterniond(a).conjugate().mul(b);
        return 2 * Math.atan2(Math.sqrt(d.x * d.x + d.y * d.y + d.z * d.z), Math.abs(d.w));
    }
}
