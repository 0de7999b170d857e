package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import nephele.engine.cloud.drawn.CloudPuffs.Puff;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/**
 * The puffs of a cloud as an eye outside of it sees them: in slabs across the direction to the cloud, so that a flat picture
 * of each is right for eyes nearby too. After Harris 2002, "Real-time cloud rendering for games", section 5, whose pictures
 * have one slab. Places are in the space of the puffs. Immutable.
 *
 * @param axes the cloud is along −back
 * @param texel side of a texel of a picture at distance 1
 * @param width of a picture in texels; {@code height} likewise
 * @param puffs those that are visible, in the order in which they are blended
 * @param slabs the farthest first
 */
public record PuffSlabs(Vec3 eye, Basis axes, double texel, int width, int height, List<Puff> puffs, List<Slab> slabs) {
    private static final int MOST_SLABS = 4;
    /** Thickness of a slab in deviations of its puffs; they stand out of it by as much anyway. */
    private static final double THICKNESS = 4;
    /** Texels of a picture in the deviation of all but the puffs that seem smallest, a tenth. */
    private static final double TEXELS_A_DEVIATION = 3.5;
    /** Texels in the deviation of the smallest one. */
    private static final double LEAST_TEXELS = 1.75;

    private static final double SMALLEST = 0.1;
    /** Greatest tangent from the direction to the cloud. */
    private static final double WIDEST = 1.2;
    /** Least distance from a puff in its radii. */
    private static final double NEAREST = 1.05;
    /** Sides of pictures are multiples of this, so that they seldom change. */
    private static final int SIDE_STEP = 32;

    private static final int LONGEST_SIDE = 1024;
    private static final double LEAST_TANGENT = 0.01;
    /** Turn of the direction to the cloud after which its light may look other, radians. */
    private static final double MOST_TURN = 1 / 32.0;

    private static final double MOST_SCALE = 1.25;

    /**
     * Puffs with a common picture.
     *
     * @param first of the puffs
     * @param end behind the last one
     * @param middle distance from the eye, along the axis, at which the picture is put, metres
     * @param near distance at which most of the puffs begins; {@code far} where it ends
     * @param core sides of what most of them fills, at distance 1
     * @param whole sides of what all of them fills
     */
    public record Slab(int first, int end, double middle, double near, double far, Sides core, Sides whole) {}

    /** The sides of a rectangle across the axis, at distance 1. */
    public record Sides(double left, double right, double low, double high) {
        private static final Sides NONE = new Sides(
                Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);

        private Sides union(Sides other) {
            return new Sides(
                    Math.min(left, other.left),
                    Math.max(right, other.right),
                    Math.min(low, other.low),
                    Math.max(high, other.high));
        }

        private double widest() {
            return Math.max(Math.max(-left, right), Math.max(-low, high));
        }

        /** Returns those of a puff at coordinates along right, up and forward. */
        private static Sides of(double x, double y, double z, double radius) {
            double across = Math.atan2(x, z);
            double up = Math.atan2(y, z);
            double halfAcross = Math.asin(Math.min(1, radius / Math.hypot(x, z)));
            double halfUp = Math.asin(Math.min(1, radius / Math.hypot(y, z)));
            return new Sides(
                    tangent(across - halfAcross),
                    tangent(across + halfAcross),
                    tangent(up - halfUp),
                    tangent(up + halfUp));
        }

        private static double tangent(double angle) {
            return Math.abs(angle) < 1.5 ? Math.tan(angle) : Math.copySign(Double.POSITIVE_INFINITY, angle);
        }
    }

    /**
     * Divides the puffs.
     *
     * @param pixel width of a pixel at distance 1: no texel is finer
     * @return empty if nothing is visible of them, or the eye is too near for one picture
     */
    public static Optional<PuffSlabs> of(CloudPuffs all, Vec3 eye, double pixel) {
        List<Puff> visible =
                all.all().stream().filter(puff -> puff.radiusMetres() > 0).toList();
        if (visible.isEmpty()) {
            return Optional.empty();
        }
        Vec3 centre = Aabb.of(visible.stream().map(Puff::centre).toList()).centre();
        Basis axes = Basis.lookAt(eye, centre, Basis.WORLD.up(), Basis.WORLD);
        Sides whole = Sides.NONE;
        double[] sizes = new double[visible.size()];
        for (int i = 0; i < sizes.length; i++) {
            Puff puff = visible.get(i);
            Vec3 to = puff.centre().minus(eye);
            double z = -to.dot(axes.back());
            if (z <= NEAREST * puff.radiusMetres()) {
                return Optional.empty();
            }
            whole = whole.union(Sides.of(to.dot(axes.right()), to.dot(axes.up()), z, puff.radiusMetres()));
            sizes[i] = puff.deviationMetres() / z;
        }
        Arrays.sort(sizes);
        double texel = Math.min(sizes[(int) (SMALLEST * sizes.length)] / TEXELS_A_DEVIATION, sizes[0] / LEAST_TEXELS);
        texel = Math.max(pixel, texel);
        int width = side(Math.max(-whole.left, whole.right), texel);
        int height = side(Math.max(LEAST_TANGENT, Math.max(-whole.low, whole.high)), texel);
        boolean fits = whole.widest() < WIDEST && Math.max(width, height) <= LONGEST_SIDE;
        return fits ? Optional.of(divided(visible, eye, axes, texel, width, height)) : Optional.empty();
    }

    private static int side(double half, double texel) {
        double texels = Math.min(2 * half / texel + 2, 1 << 20);
        return SIDE_STEP * (int) Math.ceil(texels / SIDE_STEP);
    }

    private static PuffSlabs divided(List<Puff> visible, Vec3 eye, Basis axes, double texel, int width, int height) {
        double[] depths = visible.stream()
                .mapToDouble(puff -> eye.minus(puff.centre()).dot(axes.back()))
                .toArray();
        double nearest = Arrays.stream(depths).min().orElseThrow();
        double farthest = Arrays.stream(depths).max().orElseThrow();
        double deviation =
                visible.stream().mapToDouble(Puff::deviationMetres).average().orElseThrow();
        int count = (int) Math.max(1, Math.min(MOST_SLABS, Math.round((farthest - nearest) / (THICKNESS * deviation))));
        double thickness = Math.max(1e-9, (farthest - nearest) / count);
        List<List<Puff>> groups = new ArrayList<>();
        for (int slab = 0; slab < count; slab++) {
            groups.add(new ArrayList<>());
        }
        for (int i = 0; i < depths.length; i++) {
            int slab = (int) Math.min(count - 1, (farthest - depths[i]) / thickness);
            groups.get(slab).add(visible.get(i));
        }
        List<Puff> puffs = new ArrayList<>();
        List<Slab> slabs = new ArrayList<>();
        for (List<Puff> group : groups) {
            if (!group.isEmpty()) {
                // A stable sort, so that puffs at equal distances keep their order.
                group.sort((a, b) -> Double.compare(distance(b, eye), distance(a, eye)));
                slabs.add(slab(group, puffs.size(), eye, axes));
                puffs.addAll(group);
            }
        }
        return new PuffSlabs(eye, axes, texel, width, height, List.copyOf(puffs), List.copyOf(slabs));
    }

    private static double distance(Puff puff, Vec3 eye) {
        return puff.centre().minus(eye).length();
    }

    private static Slab slab(List<Puff> group, int first, Vec3 eye, Basis axes) {
        double near = Double.POSITIVE_INFINITY;
        double far = 0;
        Sides core = Sides.NONE;
        Sides whole = Sides.NONE;
        for (Puff puff : group) {
            Vec3 to = puff.centre().minus(eye);
            double x = to.dot(axes.right());
            double y = to.dot(axes.up());
            double z = -to.dot(axes.back());
            near = Math.min(near, z - puff.deviationMetres());
            far = Math.max(far, z + puff.deviationMetres());
            core = core.union(Sides.of(x, y, z, puff.deviationMetres()));
            whole = whole.union(Sides.of(x, y, z, puff.radiusMetres()));
        }
        // Both ends are then wrong by the same angle.
        double middle = 2 * near * far / (near + far);
        return new Slab(first, first + group.size(), middle, near, far, core, whole);
    }

    public double tanHalfWidth() {
        return width * texel / 2;
    }

    public double tanHalfHeight() {
        return height * texel / 2;
    }

    /** Returns the texels that a puff is drawn into, at most. */
    public long texels(int index) {
        Puff puff = puffs.get(index);
        double z = eye.minus(puff.centre()).dot(axes.back());
        double side = 2 * puff.radiusMetres() / (z * texel);
        return Math.min((long) width * height, (long) Math.ceil(side * side));
    }

    /** Returns the texels that all puffs are drawn into. */
    public long texels() {
        long sum = 0;
        for (int puff = 0; puff < puffs.size(); puff++) {
            sum += texels(puff);
        }
        return sum;
    }

    /**
     * Returns the greatest angle by which another eye sees most of the puffs in a wrong direction, radians: that between the
     * nearest or farthest point of a slab and the place where its picture has it.
     */
    public double errorRadians(Vec3 from) {
        Vec3 moved = from.minus(eye);
        double x = moved.dot(axes.right());
        double y = moved.dot(axes.up());
        double z = -moved.dot(axes.back());
        double most = 0;
        for (int i = 0; i < slabs.size(); i++) {
            Slab slab = slabs.get(i);
            Sides core = slab.core;
            most = Math.max(
                    most, errorRadians(slab, (core.left + core.right) / 2, (core.low + core.high) / 2, x, y, z));
            most = Math.max(most, errorRadians(slab, core.left, core.low, x, y, z));
            most = Math.max(most, errorRadians(slab, core.left, core.high, x, y, z));
            most = Math.max(most, errorRadians(slab, core.right, core.low, x, y, z));
            most = Math.max(most, errorRadians(slab, core.right, core.high, x, y, z));
        }
        return most;
    }

    /**
     * Returns how much else is wrong for another eye, 1 for as much as may be: the direction from which it sees the cloud, and
     * how large the texels are.
     */
    public double otherError(Vec3 from) {
        Vec3 centre = eye.addScaled(-slabs.get(0).middle(), axes.back());
        Vec3 to = centre.minus(from);
        double metres = to.length();
        Vec3 before = centre.minus(eye);
        double turn = Math.atan2(to.cross(before).length(), to.dot(before));
        double scale = Math.abs(Math.log(Math.max(1e-9, metres) / before.length()));
        return Math.max(turn / MOST_TURN, scale / Math.log(MOST_SCALE));
    }

    /** Returns the error on a ray of the old eye, at tangents across and up, from a place relative to that eye. */
    private static double errorRadians(Slab slab, double across, double up, double x, double y, double z) {
        return Math.max(
                apart(across, up, slab.middle, slab.near, x, y, z), apart(across, up, slab.middle, slab.far, x, y, z));
    }

    private static double apart(double across, double up, double drawn, double real, double x, double y, double z) {
        double ax = across * drawn - x;
        double ay = up * drawn - y;
        double az = drawn - z;
        double bx = across * real - x;
        double by = up * real - y;
        double bz = real - z;
        if (!(az > 0 && bz > 0)) {
            return Math.PI;
        }
        double cx = ay * bz - az * by;
        double cy = az * bx - ax * bz;
        double cz = ax * by - ay * bx;
        return Math.atan2(Math.sqrt(cx * cx + cy * cy + cz * cz), ax * bx + ay * by + az * bz);
    }
}
