package nephele.engine.bake;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.reference.GatherRays;
import org.joml.Vector3dc;

/**
 * A few rays of every receiver, kept as links to the receivers at their ends: light is sent along them again and again
 * until it does not change (Jacobi's iteration of the radiosity equation), without a ray more.
 */
final class BounceLinks {
    private static final int MOST_RAYS = 64;

    private static final int LEAST_RAYS = 8;

    /** The number of all links, unless that is too few or too many for a receiver. */
    private static final int LINKS = 1_500_000;

    /** The change of all light, as a share of it, at which it is balanced. */
    private static final double BALANCED = 1e-5;

    /** An albedo of .99 needs 1,145 steps to this balance. */
    private static final int MOST_STEPS = 2000;

    private static final int CHANNELS = 3;

    /** The reflectance 1; up to twice as much fits. */
    private static final double ONE = 32767;

    private final LightBake bake;
    private final Receivers receivers;
    private final int layers;
    /** Rays of each receiver. */
    private final int rays;

    private final int[] ends;
    private final short[] reflectances;
    /** The luminance that each ray met without that of the receiver at its end. */
    private final float[] met;

    /** The light that comes from elsewhere than from receivers, or is reflected once from direct light. */
    private final float[] first;

    private float[] radiance;
    private float[] next;

    BounceLinks(LightBake bake) {
        this.bake = bake;
        receivers = bake.allReceivers();
        layers = bake.layers();
        rays = Math.max(LEAST_RAYS, Math.min(LINKS / Math.max(1, receivers.count()), MOST_RAYS));
        ends = new int[rays * receivers.count()];
        reflectances = new short[CHANNELS * ends.length];
        met = new float[ends.length];
        first = new float[CHANNELS * layers * receivers.count()];
    }

    /**
     * Traces the rays, then balances {@link LightBake#indirect}.
     *
     * @param isFree false for receivers that are inside something
     * @return the standard error of each receiver's luminance; negative for one that is not free
     */
    float[] balance(boolean[] isFree, DoubleConsumer progress) {
        bake.inParallel(progress, this::trace);
        radiance = first.clone();
        next = new float[first.length];
        double change = 1;
        for (int step = 0; step < MOST_STEPS && change > BALANCED; step++) {
            change = step();
            progress.accept(1);
        }
        float[] errors = teach(bake.guide(), isFree);
        float[] indirect = bake.indirect();
        for (int receiver = 0; receiver < receivers.count(); receiver++) {
            for (int layer = 0; layer < layers; layer++) {
                copy(CHANNELS * (receiver * layers + layer), Gathered.VALUES * (receiver * layers + layer), indirect);
            }
        }
        return errors;
    }

    private void trace(GatherRays ray, int block) {
        int[] corners = new int[Receivers.CORNERS];
        double[] weights = new double[Receivers.CORNERS];
        float[] values = new float[Gathered.VALUES * layers];
        for (int receiver = LightBake.firstOf(block); receiver < bake.lastOf(block); receiver++) {
            Receivers.Spot spot = receivers.spot(receiver);
            Arrays.fill(ends, rays * receiver, rays * (receiver + 1), -1);
            if (spot.places().isEmpty()) {
                continue;
            }
            SplittableRandom random = random(receiver);
            long shift = random.nextLong();
            Gathered sum = new Gathered(layers);
            int link = rays * receiver;
            for (int i = 0; i < rays; i++) {
                int at = link + i;
                Vec3 place = spot.places().get(5 * i % spot.places().size());
                RayGuide.Aim aim = RayGuide.Aim.even(shift, i);
                LightBake.Reflection reflection = (end, reflectance, direction, cosine, to) -> {
                    receivers.around(end, ray, corners, weights);
                    ends[at] = chosen(corners, weights, random.nextDouble());
                    keep(reflectance, at);
                    bake.addReflected(reflectance, direction, cosine, to, bake.direct(), corners, weights);
                };
                met[at] = (float) bake.addRay(ray, place, spot.normal(), aim, random, sum, reflection);
            }
            int at = receiver * Gathered.VALUES * layers;
            sum.write(1.0 / rays, values, 0);
            System.arraycopy(values, 0, bake.indirect(), at, values.length);
            for (int layer = 0; layer < layers; layer++) {
                System.arraycopy(
                        values, Gathered.VALUES * layer, first, CHANNELS * (receiver * layers + layer), CHANNELS);
            }
        }
    }

    /** Returns the random numbers of a receiver, of which the first moves its rays. */
    private static SplittableRandom random(int receiver) {
        return new SplittableRandom(Hash64.combine(receiver, 0));
    }

    /**
     * Tells a guide what the rays met, and what balanced light was at their ends.
     *
     * @return standard errors as of {@link #balance}
     */
    private float[] teach(RayGuide guide, boolean[] isFree) {
        float[] errors = new float[receivers.count()];
        for (int receiver = 0; receiver < receivers.count(); receiver++) {
            long shift = random(receiver).nextLong();
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < rays; i++) {
                int link = rays * receiver + i;
                double luminance = met[link] + balanced(link);
                guide.learn(receiver, RayGuide.Aim.even(shift, i), luminance);
                sum += luminance;
                squares += luminance * luminance;
            }
            double variance = Math.max(0, squares / rays - sum * sum / rays / rays);
            errors[receiver] = isFree[receiver] ? (float) Math.sqrt(variance / (rays - 1)) : -1;
        }
        guide.finish();
        return errors;
    }

    /** Returns the luminance that arrives of the balanced light of the receiver at a link's end. */
    private double balanced(int link) {
        double sum = 0;
        for (int layer = 0; layer < layers && ends[link] >= 0; layer++) {
            int from = CHANNELS * (ends[link] * layers + layer);
            int by = CHANNELS * link;
            sum += Gathered.luminance(
                    radiance[from] * (reflectances[by] & 0xffff),
                    radiance[from + 1] * (reflectances[by + 1] & 0xffff),
                    radiance[from + 2] * (reflectances[by + 2] & 0xffff));
        }
        return sum / ONE;
    }

    /** Returns one of the corners, each with the probability of its weight; −1 if all weights are 0. */
    private static int chosen(int[] corners, double[] weights, double at) {
        double left = at;
        int last = -1;
        for (int i = 0; i < corners.length && left >= 0; i++) {
            left -= weights[i];
            last = weights[i] > 0 ? corners[i] : last;
        }
        return last;
    }

    private void keep(Vector3dc reflectance, int link) {
        for (int channel = 0; channel < CHANNELS; channel++) {
            double value = Math.min(2, reflectance.get(channel)) * ONE;
            reflectances[CHANNELS * link + channel] = (short) Math.round(value);
        }
    }

    /** Sends light along all links once; returns the change of all light as a share of it. */
    private double step() {
        double[] sums = new double[bake.blocks()];
        double[] changes = new double[bake.blocks()];
        IntStream.range(0, bake.blocks()).parallel().forEach(block -> {
            for (int receiver = LightBake.firstOf(block); receiver < bake.lastOf(block); receiver++) {
                for (int layer = 0; layer < layers; layer++) {
                    send(receiver, layer, block, sums, changes);
                }
            }
        });
        float[] before = radiance;
        radiance = next;
        next = before;
        double sum = Arrays.stream(sums).sum();
        return sum == 0 ? 0 : Arrays.stream(changes).sum() / sum;
    }

    private void send(int receiver, int layer, int block, double[] sums, double[] changes) {
        float red = 0;
        float green = 0;
        float blue = 0;
        for (int link = rays * receiver; link < rays * (receiver + 1); link++) {
            if (ends[link] >= 0) {
                int from = CHANNELS * (ends[link] * layers + layer);
                int by = CHANNELS * link;
                red += radiance[from] * (reflectances[by] & 0xffff);
                green += radiance[from + 1] * (reflectances[by + 1] & 0xffff);
                blue += radiance[from + 2] * (reflectances[by + 2] & 0xffff);
            }
        }
        float mean = (float) (1 / (ONE * rays));
        int at = CHANNELS * (receiver * layers + layer);
        next[at] = first[at] + red * mean;
        next[at + 1] = first[at + 1] + green * mean;
        next[at + 2] = first[at + 2] + blue * mean;
        double now = Gathered.luminance(next[at], next[at + 1], next[at + 2]);
        sums[block] += now;
        changes[block] += Math.abs(now - Gathered.luminance(radiance[at], radiance[at + 1], radiance[at + 2]));
    }

    /** Copies the balanced radiance; its moments are those of the first light, strengthened alike. */
    private void copy(int from, int to, float[] indirect) {
        double before = Gathered.luminance(first[from], first[from + 1], first[from + 2]);
        double now = Gathered.luminance(radiance[from], radiance[from + 1], radiance[from + 2]);
        System.arraycopy(radiance, from, indirect, to, CHANNELS);
        for (int i = CHANNELS; i < Gathered.VALUES; i++) {
            indirect[to + i] *= (float) (before > 0 ? now / before : 0);
        }
    }
}
