package nephele.engine.cloud.field;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Cloud;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;

/**
 * Fills blocks with puffs. A block is filled as a heap: flat below, rounded above and at the sides, where x, y, z of −1
 * to 1 (y from 0 at the base) have |x|³ + |y|³ + |z|³ below 1. Puffs are large in the middle and small at the surface.
 * Their densities integrate to the volume of the heap, so that its mean density is about 1 whatever their number.
 */
public final class PuffFilling {
    /** Golden ratio of three dimensions, whose powers are spread evenly (Roberts 2018, "The R-sequence"). */
    private static final double PLASTIC = 1.2207440846057596;

    /** Size of puffs in the middle of a heap and at its surface, before they are scaled. */
    private static final double INNER = 1.3;

    private static final double OUTER = 0.5;

    /** Smallest random factor on a size; the mean is 1. */
    private static final double LEAST = 0.6;

    /** Height of the centres of the lowest puffs over the base, in radii. */
    private static final double FOOT_RADII = 0.6;

    private final List<Cloud.Puff> puffs = new ArrayList<>();
    private final long seed;

    private PuffFilling(long seed) {
        this.seed = seed;
    }

    /** Returns the listed puffs and those of the fill. */
    public static List<Cloud.Puff> all(Cloud.Density.Puffs density) {
        if (density.fill() == null) {
            return density.puffs();
        }
        List<Cloud.Puff> all = new ArrayList<>(density.puffs());
        all.addAll(of(density.fill()));
        return all;
    }

    /** Returns the puffs of a fill; a block has as many as it has of the volume. */
    public static List<Cloud.Puff> of(Cloud.PuffFill fill) {
        var filling = new PuffFilling(fill.seed());
        double all = fill.boxes().stream().mapToDouble(PuffFilling::volume).sum();
        double before = 0;
        for (Cloud.FillBox box : fill.boxes()) {
            double after = before + volume(box);
            int count = (int) (Math.round(fill.count() * after / all) - Math.round(fill.count() * before / all));
            filling.fill(box, count);
            before = after;
        }
        return filling.puffs;
    }

    private static double volume(Cloud.FillBox box) {
        return box.size().x() * box.size().y() * box.size().z();
    }

    private void fill(Cloud.FillBox box, int count) {
        long hash = Hash64.combine(seed, box.centre());
        double[] x = new double[count];
        double[] y = new double[count];
        double[] z = new double[count];
        double[] size = new double[count];
        double cubes = 0;
        int tried = 0;
        for (int n = 0; n < count; tried++) {
            double a = 2 * spread(hash, 1, tried) - 1;
            double b = spread(hash, 2, tried);
            double c = 2 * spread(hash, 3, tried) - 1;
            double cubed = Math.abs(a * a * a) + b * b * b + Math.abs(c * c * c);
            if (cubed < 1) {
                x[n] = a;
                y[n] = b;
                z[n] = c;
                double uneven = LEAST + (1 - LEAST) * 2 * random(hash, tried);
                size[n] = uneven * (INNER + (OUTER - INNER) * StrictMath.cbrt(cubed));
                cubes += size[n] * size[n] * size[n];
                n++;
            }
        }
        double heap = volume(box) * count / Math.max(1, tried);
        // A puff of radius r integrates to (2 pi)^(3/2) (r/2)^3.
        double scale = 2 * StrictMath.cbrt(heap / (2 * Math.PI * Math.sqrt(2 * Math.PI) * cubes));
        for (int n = 0; n < count; n++) {
            puffs.add(puff(box, new Vec3(x[n], y[n], z[n]), scale * size[n]));
        }
    }

    private static double random(long hash, int n) {
        return (Hash64.combine(hash, n) >>> 11) * 0x1p-53;
    }

    /** Returns the n-th number of an evenly spread sequence in 0 to 1 with a random start. */
    private static double spread(long hash, int axis, int n) {
        double power = axis == 1 ? PLASTIC : axis == 2 ? PLASTIC * PLASTIC : PLASTIC * PLASTIC * PLASTIC;
        double start = random(hash, -axis);
        double at = start + (n + 1) / power;
        return at - Math.floor(at);
    }

    /** Moves a puff inwards so that its radius keeps to the block. */
    private static Cloud.Puff puff(Cloud.FillBox box, Vec3 at, double radius) {
        Vec3 half = box.size().scaled(0.5);
        double top = Math.max(0, box.size().y() - (1 + FOOT_RADII) * radius);
        return new Cloud.Puff(
                new Vec3(
                        box.centre().x() + at.x() * Math.max(0, half.x() - radius),
                        box.centre().y() - half.y() + FOOT_RADII * radius + at.y() * top,
                        box.centre().z() + at.z() * Math.max(0, half.z() - radius)),
                radius);
    }
}
