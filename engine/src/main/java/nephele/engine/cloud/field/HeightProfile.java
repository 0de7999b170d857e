package nephele.engine.cloud.field;

import java.util.function.DoubleUnaryOperator;
import nephele.engine.level.CloudProfile;

/**
 * How a kind of cloud changes from its base, at height 0, to its top, at height 1: functions that are linear between
 * {@link #KNOTS} equidistant heights, as a one-dimensional texture is. docs/clouds.md has the formula of which they are
 * parts.
 */
public final class HeightProfile {
    public static final int KNOTS = 33;

    /** How far outside of a body a full anvil reaches. */
    private static final double SPREAD = 0.75;

    private final double falloff;
    private final double foot;
    private final double spread;
    private final double[] rise;
    private final double[] billows;
    private final double[] sharpness;
    private final double[] body;

    private HeightProfile(
            double falloff,
            double foot,
            double spread,
            DoubleUnaryOperator rise,
            DoubleUnaryOperator billows,
            DoubleUnaryOperator sharpness,
            DoubleUnaryOperator body) {
        this.falloff = falloff;
        this.foot = foot;
        this.spread = spread;
        this.rise = knots(rise);
        this.billows = knots(billows);
        this.sharpness = knots(sharpness);
        this.body = knots(body);
    }

    private static double[] knots(DoubleUnaryOperator function) {
        double[] knots = new double[KNOTS];
        for (int i = 0; i < KNOTS; i++) {
            knots[i] = function.applyAsDouble(i / (KNOTS - 1.0));
        }
        return knots;
    }

    /** @param anvil how far the top of a cumulonimbus spreads, 0 to 1; other kinds have none */
    public static HeightProfile of(CloudProfile profile, double anvil) {
        return switch (profile) {
            case STRATUS -> stratus();
            case CUMULUS -> cumulus();
            case CUMULONIMBUS -> cumulonimbus(anvil);
        };
    }

    private static HeightProfile stratus() {
        return new HeightProfile(
                0.3,
                1.2,
                0,
                h -> 0.5 * (2 * h - 1) * (2 * h - 1) * (2 * h - 1) * (2 * h - 1),
                h -> 0.5,
                h -> 2,
                h -> Math.min(1, Math.min(h / 0.15, (1 - h) / 0.3)));
    }

    private static HeightProfile cumulus() {
        return new HeightProfile(
                0.8,
                1.22,
                0,
                h -> h * h,
                h -> 0.25 + 0.35 * ramp(0, 0.3, h),
                h -> 6,
                h -> 0.4 + 0.6 * ramp(0, 0.06, h));
    }

    private static HeightProfile cumulonimbus(double anvil) {
        return new HeightProfile(
                0.8,
                1.22 - 0.3 * anvil,
                SPREAD * anvil,
                h -> 0.15
                        + 0.3 * anvil
                        + 0.4 * (1 - 0.5 * anvil) * h * h
                        + (1.3 + 0.5 * anvil) * ramp(0.93, 1, h)
                        - anvil * (SPREAD + 0.6) * ramp(0.76, 0.93, h),
                h -> 0.45 + 0.15 * ramp(0, 0.2, h) - 0.35 * anvil * ramp(0.78, 0.92, h),
                h -> 6 - 4 * anvil * ramp(0.75, 0.9, h),
                h -> (0.4 + 0.6 * ramp(0, 0.04, h)) * (1 - 0.75 * anvil * ramp(0.7, 0.85, h)));
    }

    private static double ramp(double from, double to, double at) {
        double t = Math.max(0, Math.min(1, (at - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }

    /** Returns the width of a body's edge, as a fraction of the plan. */
    double falloff() {
        return falloff;
    }

    /** Returns the fraction of the plan in which bodies begin, per fraction of the sky that is covered in the end. */
    double foot() {
        return foot;
    }

    /** Returns how far outside of a body the cloud reaches, in the units of {@link ProfiledNoise#bodyDepth}. */
    double spread() {
        return spread;
    }

    /** Returns by how much the depth of a body must exceed 0 for it to reach a height. */
    double rise(double height) {
        return interpolated(rise, height);
    }

    /** Returns how deep the shape noise dents the surface. */
    double billows(double height) {
        return interpolated(billows, height);
    }

    /** Returns the growth of density with depth. */
    double sharpness(double height) {
        return interpolated(sharpness, height);
    }

    /** Returns the greatest density. */
    double body(double height) {
        return interpolated(body, height);
    }

    /** Returns rise, billows, sharpness and body at each of {@link #KNOTS} heights, four values a height. */
    public float[] knots() {
        float[] knots = new float[4 * KNOTS];
        for (int i = 0; i < KNOTS; i++) {
            knots[4 * i] = (float) rise[i];
            knots[4 * i + 1] = (float) billows[i];
            knots[4 * i + 2] = (float) sharpness[i];
            knots[4 * i + 3] = (float) body[i];
        }
        return knots;
    }

    private static double interpolated(double[] knots, double height) {
        double at = Math.max(0, Math.min(1, height)) * (KNOTS - 1);
        int lower = Math.min((int) at, KNOTS - 2);
        return knots[lower] + (knots[lower + 1] - knots[lower]) * (at - lower);
    }

    double leastRise(double from, double to) {
        return least(rise, from, to);
    }

    double leastBillows(double from, double to) {
        return least(billows, from, to);
    }

    double greatestSharpness(double from, double to) {
        return greatest(sharpness, from, to);
    }

    double greatestBody(double from, double to) {
        return greatest(body, from, to);
    }

    private static double least(double[] knots, double from, double to) {
        double least = Math.min(interpolated(knots, from), interpolated(knots, to));
        for (int i = knotAfter(from); i < knotAfter(to); i++) {
            least = Math.min(least, knots[i]);
        }
        return least;
    }

    private static double greatest(double[] knots, double from, double to) {
        double greatest = Math.max(interpolated(knots, from), interpolated(knots, to));
        for (int i = knotAfter(from); i < knotAfter(to); i++) {
            greatest = Math.max(greatest, knots[i]);
        }
        return greatest;
    }

    private static int knotAfter(double height) {
        return (int) Math.ceil(Math.max(0, Math.min(1, height)) * (KNOTS - 1));
    }
}
