package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.Future;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.cells.LayerGrid;
import nephele.engine.cloud.cells.LayerGrid.Column;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.cells.ShadingClouds;
import nephele.engine.cloud.drawn.CloudInterval.Sample;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.CloudDemand;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.work.SwingThread;

/**
 * The clouds of a level over time. They are sampled at {@link SampleInstants}, in boxes that follow a focus; between two
 * samples they are interpolated. What a frame sees is a function of time and focus alone: the next samples are made by a
 * thread of their own, and waited for if they are late.
 */
public final class CloudTimeline implements AutoCloseable {
    private static final Vec3 NOON = new Vec3(0, 1, 0);
    /** Turn of the sun between two samples. */
    private static final double SUN_DEGREES = 2;
    /** Samples of one generation of noise. */
    private static final double EVOLUTION_SAMPLES = 8;
    /** Drift between two samples. */
    private static final double DRIFT_METRES = 150;

    /** Samples of a change of the weather. */
    private static final double WEATHER_SAMPLES = 16;

    private static final double SHORTEST_SECONDS = 4;
    /** Distance of the focus from the middle of a box at which the box is to move, in its cells. */
    private static final double FOLLOWING_CELLS = 4.5;

    private static final int KEPT = 5;

    private final Environment authored;
    private final LoadedClouds loaded;
    private final int lightDivisor;
    private final Aabb region;
    private final List<CloudSource> sources;
    /** {@code null} without shafts. */
    private final ShaftClouds shafts;

    private final SampleInstants instants;
    private final ForkJoinPool worker = new ForkJoinPool(1);
    private final Map<Key, Future<Sample>> samples = new LinkedHashMap<>(16, 0.75f, true);
    private List<List<Column>> columns;
    private double firstSeconds = Double.NaN;

    /** What a sample depends on. @param columns the middles of each cloud's boxes, then those of the shafts' shade */
    private record Key(double instant, Vec3 towardsSun, List<List<Column>> columns) {}

    /**
     * Prepares the clouds of an environment, those of its weather included.
     *
     * @param authored the environment at time 0
     * @param region of the level, which they shade
     * @param lightDivisor cells of density along each edge of a cell of light
     * @throws nephele.engine.asset.AssetException if a picture or grid is unusable
     */
    public CloudTimeline(Environment authored, AssetSource assets, Aabb region, int lightDivisor) {
        this(
                authored,
                LoadedClouds.of(authored, assets),
                region,
                lightDivisor,
                ProceduralNoise.SMOOTH,
                remembering(new HashMap<>()));
    }

    /** Returns what derives the light of each optics once. */
    private static Function<CloudOptics, CloudLight> remembering(Map<CloudOptics, CloudLight> known) {
        return optics -> known.computeIfAbsent(optics, CloudLight::new);
    }

    /**
     * Prepares loaded clouds.
     *
     * @param loaded those of the environment, each with the technique that draws it
     * @param lightDivisor cells of density along each edge of a cell of light
     * @param octaves of clouds that are drawn by technique {@code procedural}
     * @param physics makes or remembers the light of some optics; called by this constructor alone
     * @throws nephele.engine.asset.AssetException if memory does not suffice for their cells
     */
    public CloudTimeline(
            Environment authored,
            LoadedClouds loaded,
            Aabb region,
            int lightDivisor,
            ProceduralNoise octaves,
            Function<CloudOptics, CloudLight> physics) {
        this.authored = causes(authored);
        this.lightDivisor = lightDivisor;
        this.region = region;
        this.loaded = loaded;
        LoadedClouds still = loaded.withoutWind();
        CloudDemand demand = CloudDemand.of(loaded.clouds());
        demand.requireMemory(Runtime.getRuntime().maxMemory());
        List<CloudSource> all = new ArrayList<>();
        for (int i = 0; i < loaded.clouds().size(); i++) {
            Cloud cloud = loaded.clouds().get(i);
            CloudLight light = physics.apply(CloudOptics.of(cloud));
            var source = new CloudSource(cloud, still, i, light, demand, octaves);
            if (source.exists()) {
                all.add(source);
            }
        }
        sources = List.copyOf(all);
        shafts = ShaftClouds.of(authored, sources).orElse(null);
        instants = SampleInstants.of(stepSeconds(), loaded.course());
    }

    /** Returns an environment without what leaves clouds and the light in them as they are. */
    public static Environment causes(Environment environment) {
        return new Environment(
                environment.sun(),
                environment.sky() instanceof Atmosphere sky ? sky : null,
                null,
                Exposure.NEUTRAL,
                ToneCurve.CLIP,
                null,
                environment.clouds(),
                environment.weather(),
                environment.weatherSeed(),
                environment.weatherKeyframes());
    }

    private double stepSeconds() {
        double step = Double.POSITIVE_INFINITY;
        if (Daylight.moves(authored)) {
            var sky = (Atmosphere) authored.sky();
            step = SUN_DEGREES / 360 * sky.dayLengthSeconds();
        }
        step = Math.min(step, loaded.course().shortestSeconds() / WEATHER_SAMPLES);
        for (CloudSource source : sources) {
            Cloud.Motion motion = source.cloud().motion();
            if (source.evolves()) {
                step = Math.min(step, motion.evolutionSeconds() / EVOLUTION_SAMPLES);
            }
            step = Math.min(step, DRIFT_METRES / motion.greatestSpeed());
        }
        return Math.max(SHORTEST_SECONDS, step);
    }

    /** Returns true if the clouds and the light in them never change. */
    public boolean isSteady() {
        return instants.stepSeconds() == Double.POSITIVE_INFINITY;
    }

    /** Returns the clouds that have any extinction. */
    public List<CloudSource> sources() {
        return sources;
    }

    /** Returns the clouds that cast shadows into the air; {@code null} if none does. */
    public ShaftClouds shafts() {
        return shafts;
    }

    /** Returns the unit direction towards the sun of an environment, at night towards the moon; any without one. */
    public static Vec3 towardsSun(Environment environment) {
        Sun sun = Daylight.onGround(environment);
        return sun == null ? NOON : Directions.unit(sun.directionTowardsSun());
    }

    /**
     * Returns the clouds at a time.
     *
     * @param now the environment at that time; one with another sun than the written one's stands still
     * @param focus around which layers are sampled finely
     */
    public CloudInterval at(Environment now, double seconds, Vec3 focus) {
        return atCauses(causes(now), seconds, focus);
    }

    private CloudInterval atCauses(Environment now, double seconds, Vec3 focus) {
        double passed = instants.passed(seconds);
        double fromInstant = instants.from(seconds);
        double toInstant = instants.to(seconds);
        follow(now, seconds, focus);
        Sample from = sample(key(now, seconds, fromInstant, columns));
        Sample to = passed == 0 ? from : sample(key(now, seconds, toInstant, columns));
        double next = passed == 0 ? toInstant : instants.after(toInstant);
        if (next > fromInstant && hasMoved(seconds)) {
            prefetch(key(now, seconds, next, columns));
        }
        return new CloudInterval(from, to, passed, seconds);
    }

    /** Returns true once time passes, for then the next samples are wanted: those of a single picture never are. */
    private boolean hasMoved(double seconds) {
        firstSeconds = Double.isNaN(firstSeconds) ? seconds : firstSeconds;
        return seconds != firstSeconds;
    }

    /** Moves the boxes: as soon as the moved ones are sampled, at the latest when the others serve no longer. */
    private void follow(Environment now, double seconds, Vec3 focus) {
        List<Vec3> places = focuses(now, seconds, focus);
        if (columns == null) {
            columns = boxes(
                    places, i -> grid(i).around(places.get(i).x(), places.get(i).z()));
            return;
        }
        List<List<Column>> moved = boxes(places, i -> grid(i).following(
                        columns.get(i), places.get(i).x(), places.get(i).z(), FOLLOWING_CELLS));
        if (moved.equals(columns)) {
            return;
        }
        boolean serve = IntStream.range(0, places.size())
                .allMatch(i -> grid(i) == null
                        || grid(i).covers(
                                        columns.get(i),
                                        places.get(i).x(),
                                        places.get(i).z()));
        boolean isReady = prefetch(key(now, seconds, instants.from(seconds), moved))
                & (instants.passed(seconds) == 0 || prefetch(key(now, seconds, instants.to(seconds), moved)));
        if (isReady || !serve) {
            columns = moved;
        }
    }

    /** Returns the focus in the space of each cloud, then in that of the shafts' shade. */
    private List<Vec3> focuses(Environment now, double seconds, Vec3 focus) {
        List<Vec3> places = new ArrayList<>();
        sources.forEach(cloud -> places.add(focus.minus(cloud.drift(seconds))));
        if (shafts != null) {
            places.add(shafts.foot(focus, seconds, towardsSun(now)));
        }
        return places;
    }

    /** Returns the lattice of a cloud or of the shade; {@code null} for a finite cloud. */
    private LayerGrid grid(int index) {
        return index < sources.size() ? sources.get(index).grid() : shafts.grid();
    }

    private List<List<Column>> boxes(List<Vec3> places, IntFunction<List<Column>> columnsOf) {
        return IntStream.range(0, places.size())
                .mapToObj(i -> grid(i) == null ? List.<Column>of() : columnsOf.apply(i))
                .toList();
    }

    private Key key(Environment now, double seconds, double instant, List<List<Column>> at) {
        return new Key(instant, sunAt(now, seconds, instant), at);
    }

    private Vec3 sunAt(Environment now, double seconds, double instant) {
        boolean follows = Daylight.moves(authored) && now.equals(Daylight.at(authored, seconds));
        return towardsSun(follows ? Daylight.at(authored, instant) : now);
    }

    /** Begins a sample unless it is there; returns true if it is finished. */
    private boolean prefetch(Key key) {
        Future<Sample> sample = samples.computeIfAbsent(key, wanted -> worker.submit(() -> make(wanted)));
        forgetOldest();
        return sample.isDone();
    }

    private Sample sample(Key key) {
        Future<Sample> known = samples.get(key);
        if (known == null) {
            known = CompletableFuture.completedFuture(make(key));
            samples.put(key, known);
            forgetOldest();
        }
        try {
            return known.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return make(key);
        } catch (ExecutionException e) {
            throw new IllegalStateException("clouds cannot be sampled", e.getCause());
        }
    }

    private void forgetOldest() {
        if (samples.size() > KEPT) {
            samples.remove(samples.keySet().iterator().next());
        }
    }

    private Sample make(Key key) {
        SwingThread.refuse("the cells of clouds");
        double seconds = key.instant;
        List<List<CloudSource.Box>> boxes = IntStream.range(0, sources.size())
                .mapToObj(i -> sources.get(i).sample(key.columns.get(i), seconds))
                .toList();
        List<List<DensityCells>> density = boxes.stream()
                .map(all -> all.stream().map(CloudSource.Box::density).toList())
                .toList();
        ShadingClouds shading = shading(density, seconds, key.towardsSun);
        List<DrawnCloud> clouds = new ArrayList<>();
        for (int i = 0; i < sources.size(); i++) {
            CloudSource source = sources.get(i);
            var around = new LightCells.Around(key.towardsSun, shading.on(i), lightDivisor);
            CellStack lit = source.lit(density.get(i), around);
            clouds.add(new DrawnCloud(source, boxes.get(i), lit, source.drift(seconds)));
        }
        return new Sample(
                List.copyOf(clouds),
                new SunThroughClouds(clouds, key.towardsSun, region),
                SkyThroughClouds.of(clouds, key.towardsSun, region.centre()),
                groundFraction(seconds, key.towardsSun),
                shafts == null ? null : shafts.shade(key.columns.get(sources.size()), seconds, key.towardsSun));
    }

    private double groundFraction(double seconds, Vec3 towardsSun) {
        return authored.sky() instanceof Atmosphere sky
                ? loaded.groundFraction(seconds, region.centre(), towardsSun.y(), sky.groundAlbedo())
                : 1;
    }

    private ShadingClouds shading(List<List<DensityCells>> density, double seconds, Vec3 towardsSun) {
        List<ShadingClouds.Cast> all = new ArrayList<>();
        for (int i = 0; i < sources.size(); i++) {
            CloudSource source = sources.get(i);
            all.add(new ShadingClouds.Cast(
                    density.get(i), source.grid() != null, source.drift(seconds), straightened(source)));
        }
        return new ShadingClouds(all, towardsSun);
    }

    private static double straightened(CloudSource source) {
        CloudOptics optics = source.physics().optics();
        return 1 - optics.albedo() * optics.meanCosine();
    }

    @Override
    public void close() {
        worker.shutdownNow();
    }
}
