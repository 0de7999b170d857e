package nephele.engine.cloud.field;

import nephele.engine.cloud.noise.EvolvingNoise;

/**
 * Clouds of a kind: bodies in plan that narrow towards the top, with billows on them and edges that detail erodes. The
 * inside of f = depth − rise − billows (1 − shape) − 0.35 erosion · detail is cloud, and the density is the body's times
 * min(1, sharpness · f).
 */
public final class ProfiledNoise implements NoiseDensity {
    private static final double EROSION = 0.35;

    /** Relative height at which detail has turned from wisps to billows. */
    private static final double WISPS_TO = 1.0 / 6;

    private final HeightProfile profile;
    private final CloudBodies bodies;
    private final EvolvingNoise shape;
    private final EvolvingNoise detail;
    private final double erosion;
    private final double heightMetres;

    /** @param erosion 0 to 1 */
    ProfiledNoise(HeightProfile profile, CloudBodies bodies, NoiseLayouts noises, double erosion, double heightMetres) {
        this.profile = profile;
        this.bodies = bodies;
        shape = noises.shape();
        detail = noises.detail();
        this.erosion = EROSION * erosion;
        this.heightMetres = heightMetres;
    }

    public HeightProfile profile() {
        return profile;
    }

    public EvolvingNoise shape() {
        return shape;
    }

    public EvolvingNoise detail() {
        return detail;
    }

    /** Returns by how much detail can dent the surface, in the units of {@link #bodyDepth}. */
    public double eroding() {
        return erosion;
    }

    /** Returns how deep a column is inside of a body, by its place in the pattern. */
    public double bodyDepth(double x, double z) {
        return bodies.depth(x, z);
    }

    /** Returns an upper bound of {@link #bodyDepth} in a rectangle, given by its centre and half its sides. */
    public double greatestBodyDepth(double x, double z, double halfX, double halfZ) {
        return bodies.greatest(x, z, halfX, halfZ);
    }

    /** Returns the least depth inside of a body at which there is cloud at some height, in metres over the base. */
    public double leastDepth(double fromY, double toY) {
        return profile.leastRise(fromY / heightMetres, toY / heightMetres);
    }

    @Override
    public double at(double x, double y, double z) {
        return at(bodies.depth(x, z), x, y, z);
    }

    /** Returns the density at a point of a column. @param bodyDepth of the column */
    public double at(double bodyDepth, double x, double y, double z) {
        double height = y / heightMetres;
        double inside = bodyDepth - profile.rise(height);
        if (!(inside > 0)) {
            return 0;
        }
        inside -= profile.billows(height) * (1 - shape.at(x, y, z));
        if (erosion > 0 && inside > 0) {
            inside -= erosion * eroding(detail.at(x, y, z), height);
        }
        return inside > 0 ? profile.body(height) * Math.min(1, profile.sharpness(height) * inside) : 0;
    }

    @Override
    public boolean isEmpty() {
        return bodies.isEmpty();
    }

    /** Returns the distance from the detail's points, which leaves balls, and its opposite near the base. */
    static double eroding(double detail, double height) {
        double balls = Math.min(1, height / WISPS_TO);
        return 1 - detail + balls * (2 * detail - 1);
    }

    @Override
    public double greatest(double x, double y, double z, double halfX, double halfY, double halfZ) {
        double from = (y - halfY) / heightMetres;
        double to = (y + halfY) / heightMetres;
        double inside = bodies.greatest(x, z, halfX, halfZ) - profile.leastRise(from, to);
        if (!(inside > 0)) {
            return 0;
        }
        inside -= profile.leastBillows(from, to) * (1 - shape.greatest(x, y, z, halfX, halfY, halfZ));
        return inside > 0
                ? profile.greatestBody(from, to) * Math.min(1, profile.greatestSharpness(from, to) * inside)
                : 0;
    }
}
