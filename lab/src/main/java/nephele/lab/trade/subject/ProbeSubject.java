package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.bake.LightBake;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.Occluders;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.probe.LitSurfaces;
import nephele.engine.scene.probe.SkyProbes;
import nephele.engine.scene.probe.SkyProbes.Sampling;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** The light of probes against that of many rays from the places themselves, and what a walk between these places costs. */
public final class ProbeSubject implements Experiment {
    private static final Sampling[] SAMPLINGS = {
        new Sampling(2, 192),
        new Sampling(1, 192),
        new Sampling(0.5, 48),
        new Sampling(0.5, 96),
        Sampling.USUAL,
        new Sampling(0.5, 384),
        new Sampling(0.25, 192)
    };
    private static final Sampling EXACT = new Sampling(1, 6144);
    private static final int PLACES = 200;
    private static final int WALKS = 40;
    private static final double WALK_METRES = 2;
    /** The way of a walking player in one of 60 frames a second. */
    private static final double STEP_METRES = 4 / 60.0;

    /** Bodies keep as far from walls. */
    private static final double REACH_METRES = 0.3;

    public static final Trade TRADE = new Trade(
            "probes",
            new Trade.Text(
                    "Probes of light on moving things",
                    "Light of baked walls at 200 places in which a body fits. A lattice point is computed when"
                            + " something first comes near it, and serves what moves between it and its neighbours. Few"
                            + " rays miss small bright patches, far lattice points blur what is near.",
                    EXACT.rays() + " rays from each place"),
            List.of("probeMetres"),
            List.of(
                    new Setting("2 m", "192 rays"),
                    new Setting("1 m", "192 rays"),
                    new Setting("0.5 m, 48 rays", ""),
                    new Setting("0.5 m, 96 rays", ""),
                    new Setting("0.5 m", "192 rays"),
                    new Setting("0.5 m, 384 rays", ""),
                    new Setting("0.25 m", "192 rays")),
            4,
            new ErrorMetric("of the light of a side, on the mean", "%", 0.2, 1),
            List.of("worst of 20 sides, %"),
            new CostMetric("CPU a metre walked", "µs", 1e3, WALKS * WALK_METRES, CostMetric.Clock.THREAD),
            "levels/02-first-shot.json",
            site -> new ProbeSubject(site.in("levels/02-first-shot.json").placed()));

    private final StaticShapes statics;
    private final LitSurfaces surfaces;
    private final List<Vec3> places = new ArrayList<>();
    private final List<Vec3> directions = new ArrayList<>();
    private final float[] values = new float[SkyProbes.LIT_VALUES];

    private ProbeSubject(PlacedLevel placed) {
        statics = placed.statics();
        LightBake bake = LightBake.of(placed, LightBake.Settings.USUAL);
        bake.balance(done -> {});
        BakedLight sky = LevelLight.of(placed, done -> {});
        SkyVisibility visibility = sky == null ? SkyVisibility.even(LevelLight.baked(placed), false) : sky.visibility();
        surfaces = new LitSurfaces(Scene.of(placed, new BakedLight(visibility, bake.light())));
        choosePlaces();
    }

    private void choosePlaces() {
        Aabb box = statics.bounds();
        SplittableRandom random = new SplittableRandom(47);
        SkyProbes exact = probes(EXACT);
        while (places.size() < PLACES) {
            Vec3 place = new Vec3(
                    random.nextDouble(box.minX(), box.maxX()),
                    random.nextDouble(box.minY(), box.maxY()),
                    random.nextDouble(box.minZ(), box.maxZ()));
            double turn = random.nextDouble(2 * Math.PI);
            if (isFree(place)) {
                exact.exactly(place.x(), place.y(), place.z(), values, 0);
                if (mean(values) > 0) {
                    places.add(place);
                    directions.add(new Vec3(Math.cos(turn), 0, Math.sin(turn)));
                }
            }
        }
    }

    private boolean isFree(Vec3 place) {
        Occluders occluders = surfaces.occluders();
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                double[] at = {place.x(), place.y(), place.z()};
                at[axis] += side * REACH_METRES;
                if (occluders.isInside(at, -1)) {
                    return false;
                }
            }
        }
        return true;
    }

    private SkyProbes probes(Sampling sampling) {
        return new SkyProbes(statics, () -> surfaces, sampling);
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (int i = SkyProbes.VALUES; i < values.length; i++) {
            sum += values[i];
        }
        return sum / (values.length - SkyProbes.VALUES);
    }

    @Override
    public Judgement judge(int setting) {
        SkyProbes probes = probes(SAMPLINGS[setting]);
        SkyProbes exact = probes(EXACT);
        float[] expected = new float[SkyProbes.LIT_VALUES];
        List<Double> errors = new ArrayList<>();
        for (Vec3 place : places) {
            probes.at(place.x(), place.y(), place.z(), values, 0);
            exact.exactly(place.x(), place.y(), place.z(), expected, 0);
            double mean = mean(expected);
            for (int at = SkyProbes.VALUES; at < values.length; at += 3) {
                double sum = 0;
                for (int channel = 0; channel < 3; channel++) {
                    sum += Math.abs(values[at + channel] - expected[at + channel]) / 3;
                }
                errors.add(100 * sum / mean);
            }
        }
        errors.sort(null);
        double all = errors.stream().mapToDouble(Double::doubleValue).sum() / errors.size();
        return Judgement.of(all, errors.get(errors.size() * 19 / 20));
    }

    @Override
    public void run(int setting) {
        SkyProbes probes = probes(SAMPLINGS[setting]);
        for (int walk = 0; walk < WALKS; walk++) {
            for (double metres = 0; metres < WALK_METRES; metres += STEP_METRES) {
                Vec3 place = places.get(walk).addScaled(metres, directions.get(walk));
                probes.at(place.x(), place.y(), place.z(), values, 0);
            }
        }
    }
}
