package nephele.engine.cloud.light;

import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.TwoStreamSlab;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.work.SwingThread;

/**
 * The light inside a cloud in closed form, from optical depths alone: diffuse sunlight as in the slab that the cloud
 * resembles at a point, and the fraction of the sky's light from above and below that reaches it. Immutable.
 */
public final class CloudLight {
    /** Numbers of the light at a point. */
    public static final int VALUES = 5;

    /** The slab of the two-stream solution is lit at least at this angle. */
    private static final double LEAST_COSINE = 0.05;

    /** Sine of the sun's elevation below which the flow through a layer turns around gradually. */
    private static final double TURNING_SINE = 0.1;

    /** Mean diffuse radiance deep under the side of a thick cloud that the sun lights at a right angle. */
    private static final double BRIGHTEST = 5 / (4 * Math.PI);
    /** Distance from a side along its normal, divided by the distance along a ray of any direction, on the mean. */
    private static final double OBLIQUITY = 2.0 / 3;

    private final CloudOptics optics;
    private final DeltaScaling medium;
    private final SmallAngleScattering smallAngles;
    private final SlabCorrection correction;

    public CloudLight(CloudOptics optics) {
        SwingThread.refuse("the light of clouds");
        this.optics = optics;
        medium = optics.scaled();
        smallAngles = new SmallAngleScattering(optics);
        correction = new SlabCorrection(optics, smallAngles);
    }

    public CloudOptics optics() {
        return optics;
    }

    /** Returns the medium whose forward peak counts as unscattered. */
    public DeltaScaling medium() {
        return medium;
    }

    public SmallAngleScattering smallAngles() {
        return smallAngles;
    }

    /**
     * Returns I₁ along the beam of the diffuse light per unit irradiance of the beam at a point, its forward peak included. In
     * Eddington's approximation the flux is (ωg s − ∇φ/3) / (1 − ωg), s being the beam's irradiance (Ishimaru 1978, "Wave
     * Propagation and Scattering in Random Media", section 9-1). It is at most I₀, so that no radiance is negative.
     */
    public double slopeOfBeam() {
        double turned = medium.albedo() * medium.g();
        return 3 / (4 * Math.PI) * turned / (1 - turned);
    }

    /**
     * Puts the light at a point as {@link #VALUES} numbers: the optical depth towards the sun; the mean radiance of diffuse
     * sunlight per unit irradiance, I₀; what is added to it along the {@link #diffuseAxis} and subtracted against it, I₁
     * without the part that follows the beam; the fractions of the upper and of the lower sky's mean radiance that reach the
     * point.
     *
     * @param sunDepth optical depth from the point towards the sun
     * @param shadeDepth optical depth from the point away from the sun
     * @param axisCosine cosine of the angle between the beam and the {@link #diffuseAxis}, times the length of this
     * @param at place of the first number
     */
    public void put(AxisDepths depths, double sunDepth, double shadeDepth, double axisCosine, float[] values, int at) {
        double through = sunDepth + shadeDepth;
        double thickness = Math.min(depths.slabThickness(), Math.max(through, 1e-10));
        double cosine = through > thickness ? Math.max(LEAST_COSINE, thickness / through) : 1;
        double depth = Math.min(thickness, sunDepth * cosine);
        var slab = TwoStreamSlab.underBeam(medium, thickness, cosine);
        double factor = 1 + depths.flatness() * (correction.factor(depth, thickness, cosine) - 1);
        double above = openness(depths.y()) + sides(depths) / 2;
        double below = openness(depths.minusY()) + sides(depths) / 2;
        double left = remaining(depths, thickness) / (above + below);
        double mean = Math.max(0, factor * cosine * slab.diffuseMean(depth));
        double alongBeam = slopeOfBeam() * Math.exp(-medium.depthFactor() * sunDepth);
        double slope =
                factor * cosine * slab.diffuseSlope(depth) - axisCosine * Math.max(-mean, Math.min(mean, alongBeam));
        values[at] = (float) sunDepth;
        values[at + 1] = (float) mean;
        values[at + 2] = (float) slope;
        values[at + 3] = (float) (above * left);
        values[at + 4] = (float) (below * left);
    }

    /**
     * Returns the greatest mean of diffuse light at a point that an eye sees. Between the side towards the sun and the one towards
     * the eye the light is no brighter than in a slab between them: cells do not know that a point in them is near a side that
     * only the eye's ray reaches, such as a wall deep in a gap between towers.
     *
     * @param sunDepth optical depth towards the sun
     * @param eyeDepth optical depth towards the eye
     * @param exitLight fraction of the sunlight that reaches the side towards the eye
     */
    public double greatestMean(double sunDepth, double eyeDepth, double exitLight) {
        double toSun = 1 / openness(OBLIQUITY * sunDepth);
        double toEye = 1 / openness(eyeDepth);
        return BRIGHTEST * (toEye + exitLight * toSun) / (toEye + toSun);
    }

    private double sides(AxisDepths depths) {
        return openness(depths.x()) + openness(depths.minusX()) + openness(depths.z()) + openness(depths.minusZ());
    }

    /**
     * Returns a weight of light from a side. In a slab without absorption the diffuse light between two sides is the
     * mean of theirs with these weights, exactly in Eddington's approximation.
     */
    private double openness(double depth) {
        return 1 / (1 + 0.75 * (1 - medium.g()) * medium.depthFactor() * depth);
    }

    /** Returns the fraction of even light from outside that absorption leaves. */
    private double remaining(AxisDepths depths, double slabThickness) {
        double absorbed = 1 - medium.albedo();
        if (absorbed < 1e-6) {
            return 1;
        }
        double straightened = 1 - medium.albedo() * medium.g();
        double k = Math.sqrt(3 * absorbed * straightened);
        double thickness = medium.depthFactor() * slabThickness;
        double depth = Math.min(thickness / 2, medium.depthFactor() * nearestSide(depths));
        double out = 2.0 / 3 * k / straightened;
        // cosh(k (T/2 − t)) / (cosh(k T/2) + out sinh(k T/2)), written with falling exponentials.
        double rise = Math.exp(-k * depth);
        double fall = Math.exp(-k * (thickness - depth));
        double whole = Math.exp(-k * thickness);
        return (rise + fall) / (1 + whole + out * (1 - whole));
    }

    private static double nearestSide(AxisDepths d) {
        double sum = inverseSquare(d.x())
                + inverseSquare(d.minusX())
                + inverseSquare(d.y())
                + inverseSquare(d.minusY())
                + inverseSquare(d.z())
                + inverseSquare(d.minusZ());
        return 1 / Math.sqrt(sum);
    }

    private static double inverseSquare(double depth) {
        return 1 / Math.max(depth * depth, 1e-20);
    }

    /**
     * Returns the axis along which diffuse light flows, from where there is much to where there is little, in a layer: from
     * its lit side to the other.
     *
     * @param towardsSun unit
     */
    public static Vec3 diffuseAxisOfLayer(Vec3 towardsSun) {
        return new Vec3(0, -Math.max(-1, Math.min(1, towardsSun.y() / TURNING_SINE)), 0);
    }

    /**
     * Returns the axis in a finite cloud: that of a layer if it is flat, along the beam if it is not, between them a mixture,
     * which is shorter than 1.
     *
     * @param towardsSun unit
     */
    public static Vec3 diffuseAxis(Aabb extent, Vec3 towardsSun) {
        double narrowest = Math.min(extent.maxX() - extent.minX(), extent.maxZ() - extent.minZ());
        double flatness = Math.max(0, 1 - 2 * (extent.maxY() - extent.minY()) / narrowest);
        return towardsSun.scaled(flatness - 1).addScaled(flatness, diffuseAxisOfLayer(towardsSun));
    }
}
