package nephele.engine.bake;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.reference.GatherRays;
import nephele.engine.reference.SkyPanorama;
import nephele.engine.reference.TracedLevel;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.LightSamples;
import nephele.engine.scene.light.bake.SkyVisibility;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Works out the light on a level's static geometry: first the light straight from sun and lamps, then that which bounces,
 * balanced between all receivers along few rays ({@link BounceLinks}), at last gathered once more for each receiver along
 * as many rays as its error demands. Light does not pass portals, bodies do not shade it, and every surface reflects its
 * albedo evenly. The result does not depend on the number of threads.
 */
public final class LightBake {
    /** Receivers whose light is worked out, and kept by a {@link Checkpoint}, together. */
    private static final int BLOCK = 256;

    /** Every so manieth receiver of a block is looked at for its distance to a place. */
    private static final int DISTANCE_STEP = 16;

    /** Independent estimates of a receiver, from whose spread the error follows. */
    private static final int GROUPS = 8;

    /** Rays of each group between two looks at the error. */
    private static final int ROUND = 12;

    /** The share of the level's mean below which a receiver's error is absolute. */
    private static final double DIM = 0.05;

    /** The multiple of the level's mean above which a receiver's error is absolute. */
    private static final double BRIGHT = 1.5;

    private final Settings settings;
    private final TracedLevel traced;
    private final GatherRays.Sources sources;
    /** {@code null} if each ray finds the sky itself. */
    private final SkyPanorama panorama;

    private final Receivers receivers;
    /** The names of the layers, the nameless one first. */
    private final List<String> names;
    /** The layer of each lamp. */
    private final int[] layerOfLamp;

    private final boolean hasSun;
    /** Light straight from sun and lamps: {@link Gathered#VALUES} values for each receiver and layer. */
    private final float[] direct;

    /** Light that comes otherwise, in the same order. */
    private final float[] indirect;

    private final float[] errors;
    /** All light of each receiver as it was balanced: what the rays of {@link #gather} find. */
    private final float[] balanced;

    private final RayGuide guide;
    private double mean;

    /**
     * Settings of a bake.
     *
     * @param error standard error at which a receiver is done, as a share of its light
     * @param mostRays the most rays of a receiver, of all groups together
     */
    public record Settings(double error, int mostRays) {
        public static final Settings USUAL = new Settings(0.03, 2048);

        /** Returns these settings for another error, with as many more or fewer rays as it takes. */
        public Settings withError(double other) {
            double rays = mostRays * (error / other) * (error / other);
            return new Settings(other, (int) Math.max(GROUPS * ROUND, Math.min(rays, 1 << 20)));
        }
    }

    /** A store of finished blocks; called from several threads. */
    public interface Checkpoint {
        /** A store that keeps nothing. */
        Checkpoint NONE = new Checkpoint() {
            @Override
            public Optional<float[]> known(int block) {
                return Optional.empty();
            }

            @Override
            public void store(int block, float[] values) {}
        };

        /** Returns a block's values if they were stored before. */
        Optional<float[]> known(int block);

        void store(int block, float[] values);
    }

    /**
     * The standard errors of the receivers that any light reaches, as shares of the level's mean.
     *
     * @param percentile99 the error that 99 % of them do not exceed
     */
    public record Error(double median, double percentile99) {}

    private LightBake(PlacedLevel placed, Settings settings, LightMapLayout layout) {
        this.settings = settings;
        Level level = placed.level();
        StaticShapes statics = placed.statics().split(SkyVisibility.MODEL_EDGE_METRES);
        Level still = RecordCopy.with(level, "bodies", List.of());
        traced = TracedLevel.of(new PlacedLevel(still, placed.assets(), statics), ColourDecoding.SRGB);
        sources = Daylight.moves(level.environment()) ? GatherRays.Sources.LAMPS : GatherRays.Sources.ALL;
        hasSun = level.environment().sun() != null && sources == GatherRays.Sources.ALL;
        panorama = sources == GatherRays.Sources.ALL ? panorama(level, statics.bounds()) : null;
        receivers = new Receivers(layout, statics);
        List<Light> lamps = traced.lamps();
        names = new ArrayList<>(List.of(""));
        lamps.stream().map(Light::layer).filter(Objects::nonNull).distinct().forEach(names::add);
        layerOfLamp = lamps.stream()
                .mapToInt(lamp -> lamp.layer() == null ? 0 : names.indexOf(lamp.layer()))
                .toArray();
        int values = Gathered.VALUES * names.size() * receivers.count();
        direct = new float[values];
        indirect = new float[values];
        errors = new float[receivers.count()];
        balanced = new float[values];
        guide = new RayGuide(receivers);
    }

    /** Returns the sky as the top of the level sees it, or {@code null} if that is inside a cloud. */
    private SkyPanorama panorama(Level level, Aabb bounds) {
        Vec3 middle = bounds.centre();
        Vec3 top = new Vec3(middle.x(), bounds.maxY(), middle.z());
        boolean isInCloud =
                WeatherClouds.all(level.environment()).stream().anyMatch(cloud -> isAround(cloud.extent(), top));
        return isInCloud ? null : traced.panorama(top).orElse(null);
    }

    private static boolean isAround(Cloud.Extent extent, Vec3 place) {
        if (extent instanceof Cloud.Extent.Layer layer) {
            double above = place.y() - layer.baseAltitudeMetres();
            return above >= 0 && above <= layer.thicknessMetres();
        }
        Cloud.Extent.Volume volume = (Cloud.Extent.Volume) extent;
        Vec3 from = place.minus(volume.centre());
        return Math.abs(from.x()) <= volume.size().x() / 2
                && Math.abs(from.y()) <= volume.size().y() / 2
                && Math.abs(from.z()) <= volume.size().z() / 2;
    }

    /**
     * Prepares the bake of a level.
     *
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static LightBake of(PlacedLevel placed, Settings settings) {
        return of(placed, settings, LightMapLayout.of(placed.statics().solids()));
    }

    /** Prepares the bake of a level with texels of a layout of its solids. */
    public static LightBake of(PlacedLevel placed, Settings settings, LightMapLayout layout) {
        return new LightBake(placed, settings, layout);
    }

    /** Returns the number of blocks that a {@link Checkpoint} may hold. */
    public int blocks() {
        return (receivers.count() + BLOCK - 1) / BLOCK;
    }

    /** Returns the number of texels, vertices and points at which light is baked. */
    public int receivers() {
        return receivers.count();
    }

    /**
     * Balances the light along few rays; {@link #light} is a coarse picture then.
     *
     * @param progress receives the completed fraction, 0–1, from several threads; an exception that it throws ends the bake
     */
    public void balance(DoubleConsumer progress) {
        boolean[] isFree = new boolean[receivers.count()];
        inParallel(done -> progress.accept(done / 4), (ray, block) -> gatherDirect(ray, block, isFree));
        receivers.standIn(isFree);
        int length = Gathered.VALUES * names.size();
        System.arraycopy(receivers.joined(direct, length), 0, direct, 0, direct.length);
        float[] noise = new BounceLinks(this).balance(isFree, done -> progress.accept(0.25 + 0.75 * done));
        double sum = 0;
        for (int receiver = 0; receiver < receivers.count(); receiver++) {
            sum += luminance(indirect, receiver) + luminance(direct, receiver);
        }
        mean = sum / Math.max(1, receivers.count());
        for (int i = 0; i < balanced.length; i++) {
            balanced[i] = indirect[i] + direct[i];
        }
        filter(noise);
    }

    /** @param noise standard errors of luminance, negative for receivers that are not free */
    private void filter(float[] noise) {
        int length = Gathered.VALUES * names.size();
        float[] filtered = new NoiseFilter(receivers, length, indirect, noise).filtered();
        System.arraycopy(receivers.joined(filtered, length), 0, indirect, 0, filtered.length);
    }

    /**
     * Gathers the balanced light once more.
     *
     * @param checkpoint holds blocks of an earlier, interrupted bake of the same level
     * @param progress as of {@link #balance}
     */
    public void gather(Checkpoint checkpoint, DoubleConsumer progress) {
        gather(IntStream.range(0, blocks()).toArray(), checkpoint, progress);
    }

    /** Returns the numbers of all blocks, those nearest to a place first. */
    public int[] blocksFrom(Vec3 place) {
        double[] metres = new double[blocks()];
        for (int block = 0; block < metres.length; block++) {
            metres[block] = Double.POSITIVE_INFINITY;
            for (int receiver = firstOf(block); receiver < lastOf(block); receiver += DISTANCE_STEP) {
                metres[block] = Math.min(
                        metres[block], receivers.place(receiver).minus(place).length());
            }
        }
        return IntStream.range(0, metres.length)
                .boxed()
                .sorted(Comparator.comparingDouble(block -> metres[block]))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    /**
     * Gathers the balanced light once more, block by block. The light is the same in any order; meanwhile {@link #light} is
     * that of finished blocks and the balanced one of others.
     *
     * @param order the numbers of all blocks
     * @param checkpoint as of {@link #gather(Checkpoint, DoubleConsumer)}
     * @param progress as of {@link #balance}; called after each receiver
     */
    public void gather(int[] order, Checkpoint checkpoint, DoubleConsumer progress) {
        int length = Gathered.VALUES * names.size();
        AtomicInteger done = new AtomicInteger();
        inParallel(order, (ray, block) -> {
            int first = firstOf(block);
            int count = lastOf(block) - first;
            float[] values = checkpoint.known(block).orElse(null);
            if (values == null || values.length != count * (length + 1)) {
                values = new float[count * (length + 1)];
                for (int i = 0; i < count; i++) {
                    gatherIndirect(ray, first + i, values, i * (length + 1));
                    progress.accept((double) done.incrementAndGet() / receivers.count());
                }
                checkpoint.store(block, values);
            } else {
                progress.accept((double) done.addAndGet(count) / receivers.count());
            }
            for (int i = 0; i < count; i++) {
                System.arraycopy(values, i * (length + 1), indirect, (first + i) * length, length);
                errors[first + i] = values[i * (length + 1) + length];
            }
        });
        filter(absolute());
    }

    private float[] absolute() {
        float[] absolute = errors.clone();
        for (int i = 0; i < absolute.length; i++) {
            absolute[i] *= (float) mean;
        }
        return absolute;
    }

    /** Runs both parts of the bake. */
    public void run(Checkpoint checkpoint, DoubleConsumer progress) {
        balance(done -> progress.accept(done / 10));
        gather(checkpoint, done -> progress.accept(0.1 + 0.9 * done));
    }

    /** The work on one block by one thread's rays. */
    interface BlockWork {
        void run(GatherRays ray, int block);
    }

    void inParallel(DoubleConsumer progress, BlockWork work) {
        AtomicInteger done = new AtomicInteger();
        inParallel(IntStream.range(0, blocks()).toArray(), (ray, block) -> {
            work.run(ray, block);
            progress.accept((double) done.incrementAndGet() / blocks());
        });
    }

    /** Begins the work on blocks in an order. */
    private void inParallel(int[] order, BlockWork work) {
        AtomicInteger begun = new AtomicInteger();
        ThreadLocal<GatherRays> rays = ThreadLocal.withInitial(() -> traced.gatherRays(sources, panorama));
        IntStream.range(0, order.length)
                .parallel()
                .forEach(any -> work.run(rays.get(), order[begun.getAndIncrement()]));
    }

    Receivers allReceivers() {
        return receivers;
    }

    int layers() {
        return names.size();
    }

    float[] direct() {
        return direct;
    }

    float[] indirect() {
        return indirect;
    }

    RayGuide guide() {
        return guide;
    }

    int lastOf(int block) {
        return Math.min((block + 1) * BLOCK, receivers.count());
    }

    static int firstOf(int block) {
        return block * BLOCK;
    }

    private double luminance(float[] values, int receiver) {
        double sum = 0;
        for (int layer = 0; layer < names.size(); layer++) {
            int at = Gathered.VALUES * (receiver * names.size() + layer);
            sum += Gathered.luminance(values[at], values[at + 1], values[at + 2]);
        }
        return sum;
    }

    private void gatherDirect(GatherRays ray, int block, boolean[] isFree) {
        for (int receiver = firstOf(block); receiver < lastOf(block); receiver++) {
            Receivers.Spot spot = receivers.spot(receiver);
            Gathered sum = new Gathered(names.size());
            SplittableRandom random = new SplittableRandom(Hash64.combine(receiver, GROUPS));
            for (Vec3 place : spot.places()) {
                for (int light = hasSun ? -1 : 0; light < layerOfLamp.length; light++) {
                    Vector3d radiance = ray.direct(light, place, spot.normal(), random);
                    int layer = light < 0 ? 0 : layerOfLamp[light];
                    sum.add(layer, ray.towards(), ray.towards().dot(spot.normal()), radiance, 1);
                }
            }
            isFree[receiver] = !spot.places().isEmpty();
            sum.write(1.0 / Math.max(1, spot.places().size()), direct, receiver * Gathered.VALUES * names.size());
        }
    }

    /** What receivers reflect. */
    interface Reflection {
        /**
         * Adds the light of the receivers at the end of a ray.
         *
         * @param reflectance RGB radiance that arrives for each unit of their irradiance / π
         * @param direction in which it arrives, with the {@code cosine} to the normal
         */
        void add(GatherRays.End end, Vector3dc reflectance, Vector3dc direction, double cosine, Gathered to);
    }

    /**
     * Traces one ray of a receiver and adds its light and that of an emissive face. Off surfaces on which no light is
     * baked, as leaves, it goes on in a random direction.
     *
     * @param place from which it leaves
     * @return the luminance that it met, times the weight of its aim
     */
    double addRay(
            GatherRays ray,
            Vec3 place,
            Vector3dc normal,
            RayGuide.Aim aim,
            SplittableRandom random,
            Gathered to,
            Reflection reflection) {
        double before = to.luminance();
        double cosine = Math.sqrt(1 - aim.u());
        Vector3d direction = direction(normal, aim.u(), aim.v(), cosine);
        Vector3d origin = lifted(place, normal);
        GatherRays.End end = ray.trace(origin, direction, random);
        to.add(0, direction, cosine, ray.arriving(), aim.weight());
        if (luminance(ray.emitted()) > 0) {
            to.add(0, direction, cosine, ray.emitted(), aim.weight() * ray.emittedWeight(cosine, origin));
        }
        Vector3d reflectance = new Vector3d(ray.reflectance()).mul(aim.weight());
        while (end == GatherRays.End.OTHER && survives(reflectance, random)) {
            end = scattered(ray, random, reflectance, direction, cosine, to);
        }
        if (end != GatherRays.End.OPEN && end != GatherRays.End.OTHER) {
            reflection.add(end, reflectance, direction, cosine, to);
        }
        double met = to.luminance() - before;
        if (ray.hasEmissive()) {
            Vector3d radiance = ray.emission(place, normal, random);
            to.add(0, ray.towards(), ray.towards().dot(normal), radiance, 1);
        }
        return met;
    }

    /** Ends a ray with the probability that its end's light is not worth more, and makes up for it (Russian roulette). */
    private static boolean survives(Vector3d reflectance, SplittableRandom random) {
        double survival = Math.min(1, reflectance.get(reflectance.maxComponent()));
        reflectance.div(survival);
        return random.nextDouble() < survival;
    }

    /** Adds the light straight on a ray's end, then traces on from there; changes what the next end's light is worth. */
    private GatherRays.End scattered(
            GatherRays ray,
            SplittableRandom random,
            Vector3d reflectance,
            Vector3dc direction,
            double cosine,
            Gathered to) {
        Vec3 place = ray.place();
        Vector3d normal = new Vector3d(ray.normal());
        for (int light = hasSun ? -1 : 0; light < layerOfLamp.length; light++) {
            Vector3d radiance = ray.direct(light, place, normal, random).mul(reflectance);
            to.add(light < 0 ? 0 : layerOfLamp[light], direction, cosine, radiance, 1);
        }
        double u = random.nextDouble();
        Vector3d onwards = direction(normal, u, random.nextDouble(), Math.sqrt(1 - u));
        GatherRays.End end = ray.trace(lifted(place, normal), onwards, random);
        to.add(
                0,
                direction,
                cosine,
                new Vector3d(ray.arriving()).add(ray.emitted()).mul(reflectance),
                1);
        reflectance.mul(ray.reflectance());
        return end;
    }

    private static double luminance(Vector3dc rgb) {
        return Gathered.luminance(rgb.x(), rgb.y(), rgb.z());
    }

    private static Vector3d lifted(Vec3 place, Vector3dc normal) {
        double largest = Math.max(Math.abs(place.x()), Math.max(Math.abs(place.y()), Math.abs(place.z())));
        return place.toVector().fma(Math.max(1e-7, 8 * Math.ulp(largest)), normal);
    }

    /** Returns a direction of the hemisphere about a normal with a density of cosine / π (Malley's method). */
    private static Vector3d direction(Vector3dc normal, double u, double v, double cosine) {
        Vector3d across = Directions.perpendicular(Vec3.of(normal)).toVector();
        Vector3d up = normal.cross(across, new Vector3d());
        double radius = Math.sqrt(u);
        double angle = 2 * Math.PI * v;
        return new Vector3d(normal)
                .mul(cosine)
                .fma(radius * StrictMath.cos(angle), across)
                .fma(radius * StrictMath.sin(angle), up);
    }

    private void gatherIndirect(GatherRays ray, int receiver, float[] to, int at) {
        Receivers.Spot spot = receivers.spot(receiver);
        if (spot.places().isEmpty()) {
            to[at + Gathered.VALUES * names.size()] = -1;
            return;
        }
        Gathered[] groups = new Gathered[GROUPS];
        long[] shifts = new long[GROUPS];
        SplittableRandom random = new SplittableRandom(Hash64.combine(receiver, GROUPS + 1));
        for (int i = 0; i < GROUPS; i++) {
            groups[i] = new Gathered(names.size());
            shifts[i] = random.nextLong();
        }
        int[] corners = new int[Receivers.CORNERS];
        double[] weights = new double[Receivers.CORNERS];
        Reflection reflection = (end, reflectance, direction, cosine, sum) -> {
            receivers.around(end, ray, corners, weights);
            addReflected(reflectance, direction, cosine, sum, balanced, corners, weights);
        };
        int rays = 0;
        double error = Double.POSITIVE_INFINITY;
        while (rays * GROUPS < settings.mostRays() && error > 1) {
            for (int group = 0; group < GROUPS; group++) {
                for (int i = rays; i < rays + ROUND; i++) {
                    Vec3 place = spot.places()
                            .get((5 * i + 3 * group) % spot.places().size());
                    RayGuide.Aim aim = guide.guided(receiver, RayGuide.Aim.even(shifts[group], i));
                    addRay(ray, place, spot.normal(), aim, random, groups[group], reflection);
                }
            }
            rays += ROUND;
            error = error(groups, rays);
        }
        Gathered all = new Gathered(names.size());
        for (Gathered group : groups) {
            all.add(group);
        }
        all.write(1.0 / (rays * GROUPS), to, at);
        to[at + Gathered.VALUES * names.size()] = (float) (standardError(groups, rays) / mean);
    }

    /** Returns the standard error as a share of the one that is asked for. */
    private double error(Gathered[] groups, int rays) {
        double sum = 0;
        for (Gathered group : groups) {
            sum += group.luminance() / (rays * GROUPS);
        }
        double asked = settings.error() * Math.max(DIM * mean, Math.min(sum, BRIGHT * mean));
        return asked == 0 ? 0 : standardError(groups, rays) / asked;
    }

    private static double standardError(Gathered[] groups, int rays) {
        double sum = 0;
        double squares = 0;
        for (Gathered group : groups) {
            double value = group.luminance() / rays;
            sum += value;
            squares += value * value;
        }
        double variance = Math.max(0, squares / GROUPS - sum * sum / (GROUPS * GROUPS));
        return Math.sqrt(variance / (GROUPS - 1));
    }

    /** Adds what the end of a ray reflects of the light of some receivers. */
    void addReflected(
            Vector3dc reflectance,
            Vector3dc direction,
            double cosine,
            Gathered to,
            float[] light,
            int[] corners,
            double[] weights) {
        for (int layer = 0; layer < names.size(); layer++) {
            double red = 0;
            double green = 0;
            double blue = 0;
            for (int i = 0; i < Receivers.CORNERS; i++) {
                int at = Gathered.VALUES * (corners[i] * names.size() + layer);
                red += weights[i] * light[at];
                green += weights[i] * light[at + 1];
                blue += weights[i] * light[at + 2];
            }
            to.add(layer, direction, cosine, reflectance.x() * red, reflectance.y() * green, reflectance.z() * blue);
        }
    }

    /** Returns the errors of the last {@link #gather}. */
    public Error error() {
        double[] sorted = IntStream.range(0, errors.length)
                .filter(i -> errors[i] >= 0 && luminance(indirect, i) > 0)
                .mapToDouble(i -> errors[i])
                .sorted()
                .toArray();
        return sorted.length == 0
                ? new Error(0, 0)
                : new Error(sorted[sorted.length / 2], sorted[(int) (0.99 * (sorted.length - 1))]);
    }

    /** Returns the light as far as it was worked out. */
    public IndirectLight light() {
        List<IndirectLight.Layer> layers = new ArrayList<>();
        for (int layer = 0; layer < names.size(); layer++) {
            layers.add(layer(layer, IndirectLight.Course.INDIRECT, indirect));
            if (isLit(layer)) {
                layers.add(layer(layer, IndirectLight.Course.DIRECT, direct));
            }
        }
        IndirectLight.SkyLight sky =
                sources == GatherRays.Sources.ALL ? IndirectLight.SkyLight.BAKED : IndirectLight.SkyLight.LIVE;
        return new IndirectLight(sky, layers);
    }

    private boolean isLit(int layer) {
        return layer == 0 && hasSun || Arrays.stream(layerOfLamp).anyMatch(of -> of == layer);
    }

    private IndirectLight.Layer layer(int layer, IndirectLight.Course course, float[] values) {
        LightMapLayout layout = receivers.layout();
        LightSamples texels = LightSamples.black(layout.width() * layout.height());
        for (int chart = 0; chart < layout.charts().size(); chart++) {
            int columns = layout.charts().get(chart).columns();
            int rows = layout.charts().get(chart).rows();
            for (int row = 0; row < rows; row++) {
                int to = (layout.rowOf()[chart] + row) * layout.width() + layout.columnOf()[chart];
                copy(values, layer, receivers.firstOfChart(chart) + row * columns, columns, texels, to);
            }
        }
        LightSamples vertices = LightSamples.black(receivers.vertices());
        copy(values, layer, receivers.texels(), receivers.vertices(), vertices, 0);
        List<LightSamples> grounds = new ArrayList<>();
        for (int terrain = 0; terrain < receivers.statics().ground().size(); terrain++) {
            int first = receivers.firstOfGround(terrain);
            int end = terrain + 1 < receivers.statics().ground().size()
                    ? receivers.firstOfGround(terrain + 1)
                    : receivers.count();
            LightSamples ground = LightSamples.black(end - first);
            copy(values, layer, first, end - first, ground, 0);
            grounds.add(ground);
        }
        return new IndirectLight.Layer(names.get(layer), course, texels, vertices, grounds);
    }

    private void copy(float[] values, int layer, int first, int count, LightSamples to, int at) {
        for (int i = 0; i < count; i++) {
            int from = Gathered.VALUES * (receivers.standsFor(first + i) * names.size() + layer);
            System.arraycopy(values, from, to.radiance(), LightSamples.CHANNELS * (at + i), LightSamples.CHANNELS);
            System.arraycopy(
                    values,
                    from + LightSamples.CHANNELS,
                    to.moments(),
                    LightSamples.MOMENTS * (at + i),
                    LightSamples.MOMENTS);
        }
    }
}
