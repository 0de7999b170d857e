package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import nephele.engine.choice.ChosenTechniques;
import nephele.engine.choice.CloudColumns;
import nephele.engine.choice.ErrorTable;
import nephele.engine.choice.TechniqueChoice;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.View;
import nephele.engine.sim.reach.EyeReach;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import nephele.lab.technique.DrawnSky;
import nephele.lab.technique.SkyView;
import nephele.lab.technique.TableCase;
import nephele.lab.technique.TableMaker;
import nephele.lab.technique.TracedSkies;
import nephele.lab.technique.TracedSky;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Compares what technique auto chooses with each technique for all clouds, against traced pictures. */
public final class CloudAutoProof implements Proof {
    static final List<String> SKIES = List.of(
            "weather-few",
            "weather-scattered",
            "weather-broken",
            "weather-overcast",
            "weather-cirrus",
            "weather-storm",
            "clouds-cumulus",
            "clouds-stratus",
            "clouds-image-grey",
            "clouds-puffs",
            "clouds-grid",
            "clouds-ellipsoid");
    static final int PLACES = 3;
    private static final double[] SUNS = {12, 30, 60};
    private static final double SUN_AZIMUTH_DEGREES = 110;
    /** Half the width of where the eye can be. */
    private static final double STRIDE_METRES = 6;

    private static final Cloud.Tolerance TOLERANCE = new Cloud.Tolerance(1, 20);
    private static final int SAMPLES = 128;
    private static final int MOST_OUTSIDE = 3;
    private static final double MOST_EXCESS = 1.5;
    private static final double MOST_COST = 1.1;

    private static final String OUTSIDE = "cases outside the tolerance while another technique is inside";
    private static final String UNDECIDED = "cases in which no technique is inside";
    private static final String COST = "cost of what is chosen";
    private static final String CHEAPEST = "cost of the cheapest technique inside";

    private final int samples;
    private final TracedSkies traced = TracedSkies.shipped();
    private final boolean isTimed;

    public CloudAutoProof() {
        this(SAMPLES, true);
    }

    CloudAutoProof(int samples, boolean isTimed) {
        this.samples = samples;
        this.isTimed = isTimed;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-auto",
                "Over 12 skies of the samples, 3 heights of the sun and 3 places that the table of errors has not"
                        + " seen, what technique auto chooses is outside of an allowed error of 1 pixel and 20 % in at"
                        + " most 3 cases, by at most 1.5 times, where another technique is inside; it costs at most a"
                        + " tenth more than the cheapest technique that is inside.",
                "cases",
                cases(),
                9);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        try (GlContext gl = GlContext.offscreen()) {
            return ProofResult.ofUnits(from, count, progress, unit -> compared(gl, caseOf((int) unit, TOLERANCE)));
        }
    }

    private ProofResult compared(GlContext gl, Case one) {
        SkyView sky = one.sky();
        TracedSky exact = traced.of(sky, samples);
        Environment environment = sky.level().environment();
        var columns = CloudColumns.of(environment, sky.assets());
        var chosen = ChosenTechniques.of(environment, columns, one.reach(), ErrorTable.shipped());
        Map<CloudTechnique, Measured> fixed = new EnumMap<>(CloudTechnique.class);
        for (CloudTechnique technique : candidates(environment)) {
            fixed.put(technique, measured(gl, one, exact, sky.drawnBy(technique), pixels(chosen, technique)));
        }
        Measured auto = uniform(chosen) == null
                ? measured(gl, one, exact, drawn(sky, chosen), pixelsOfChosen(chosen))
                : fixed.get(uniform(chosen));
        return judged(one.name(), chosen, auto, fixed);
    }

    /** What a technique shows and costs. */
    private record Measured(double percent, double pixels, double cost) {
        double excess() {
            return Math.max(percent / TOLERANCE.maxErrorPercent(), pixels / TOLERANCE.maxErrorPixels());
        }

        boolean isInside() {
            return excess() <= 1;
        }
    }

    private Measured measured(GlContext gl, Case one, TracedSky exact, PlacedLevel placed, double pixels) {
        double percent = exact.size() == 0 ? 0 : exact.errorPercent(DrawnSky.picture(gl, one.sky(), placed));
        double cost = isTimed ? DrawnSky.cloudCost(gl, one.sky(), placed, new Stopwatch()) : 1;
        return new Measured(percent, pixels, cost);
    }

    /** Returns the technique of all clouds; {@code null} if they differ. */
    private static CloudTechnique uniform(ChosenTechniques chosen) {
        List<CloudTechnique> all = chosen.techniques().stream().distinct().toList();
        return all.size() == 1 ? all.get(0) : null;
    }

    private static List<CloudTechnique> candidates(Environment environment) {
        List<CloudTechnique> all =
                new ArrayList<>(TableMaker.techniques(environment.clouds().get(0)));
        boolean moves =
                environment.clouds().stream().anyMatch(cloud -> !cloud.motion().equals(Cloud.Motion.STILL));
        if (moves) {
            all.remove(CloudTechnique.SKYBOX);
        }
        return all;
    }

    private static PlacedLevel drawn(SkyView sky, ChosenTechniques chosen) {
        List<Cloud> clouds = new ArrayList<>();
        for (int i = 0; i < chosen.clouds().size(); i++) {
            clouds.add(chosen.clouds().get(i).with(chosen.techniques().get(i)));
        }
        Level level = sky.level();
        return PlacedLevel.of(level.with(level.environment().withClouds(clouds), level.lights()), sky.assets());
    }

    private static double pixels(ChosenTechniques chosen, CloudTechnique technique) {
        return chosen.choices().stream()
                .mapToDouble(choice -> TechniqueChoice.errorPixels(technique, choice.situation()))
                .max()
                .orElse(0);
    }

    private static double pixelsOfChosen(ChosenTechniques chosen) {
        return chosen.choices().stream()
                .mapToDouble(choice -> choice.chosen().errorPixels())
                .max()
                .orElse(0);
    }

    private static ProofResult judged(
            String name, ChosenTechniques chosen, Measured auto, Map<CloudTechnique, Measured> fixed) {
        Measured cheapest = fixed.values().stream()
                .filter(Measured::isInside)
                .min((a, b) -> Double.compare(a.cost(), b.cost()))
                .orElse(null);
        List<String> failures = new ArrayList<>();
        List<Figure> figures = new ArrayList<>();
        boolean isOutside = cheapest != null && !auto.isInside();
        figures.add(Figure.sum(OUTSIDE, isOutside ? 1 : 0, ""));
        figures.add(Figure.sum(UNDECIDED, cheapest == null ? 1 : 0, ""));
        if (isOutside) {
            figures.add(Figure.greatest("error there, of the allowed one", auto.excess(), ", " + name));
        }
        if (isOutside && auto.excess() > MOST_EXCESS) {
            failures.add(text("%s: %.2f times the allowed error by %s", name, auto.excess(), chosen.techniques()));
        }
        if (cheapest != null && auto.isInside()) {
            figures.add(Figure.sum(COST, auto.cost(), "quads"));
            figures.add(Figure.sum(CHEAPEST, cheapest.cost(), "quads"));
        }
        return ProofResult.of(1, failures, figures);
    }

    @Override
    public ProofResult judged(ProofResult soFar) {
        List<String> failures = new ArrayList<>(soFar.examples());
        int more = 0;
        if (soFar.value(OUTSIDE) > MOST_OUTSIDE) {
            failures.add(text("%.0f cases outside", soFar.value(OUTSIDE)));
            more++;
        }
        if (soFar.value(COST) > MOST_COST * soFar.value(CHEAPEST)) {
            failures.add(text("%.3f times the cost", soFar.value(COST) / soFar.value(CHEAPEST)));
            more++;
        }
        return new ProofResult(soFar.units(), soFar.failures() + more, soFar.figures(), failures);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }

    /** Twelve sample skies in the light of three suns, each from three places: none of them is in the table of errors. The sky is the table's. */
    private static int cases() {
        return SKIES.size() * SUNS.length * PLACES;
    }

    /**
     * One case.
     *
     * @param sky all of its clouds with technique auto
     * @param tolerance allowed for each of them
     */
    record Case(String name, SkyView sky, EyeReach reach) {}

    private static Case caseOf(int unit, Cloud.Tolerance tolerance) {
        String name = SKIES.get(unit / (SUNS.length * PLACES));
        double sun = SUNS[unit / PLACES % SUNS.length];
        int place = unit % PLACES;
        OpenedLevel opened = new LevelName("levels/samples/" + name + ".json").open();
        Environment environment = lit(opened.placed().level().environment(), sun);
        List<Cloud> clouds = new ArrayList<>();
        WeatherClouds.all(environment).forEach(cloud -> clouds.add(cloud.with(tolerance)));
        Environment written =
                environment.with((nephele.engine.level.Weather) null, 0).withClouds(clouds);
        View view = autoView(clouds.get(0), place);
        Vec3 eye = view.eye();
        var around = Aabb.around(eye, new Vec3(2 * STRIDE_METRES, 2, 2 * STRIDE_METRES));
        return new Case(
                name + ", sun at " + (int) sun + " degrees, place " + (place + 1),
                SkyView.alone(name, written, opened.assets(), view),
                new EyeReach(List.of(new EyeReach.Part(around, EyeReach.Means.WALKING))));
    }

    private static Environment lit(Environment environment, double sunDegrees) {
        double up = Math.toRadians(sunDegrees);
        double aside = Math.toRadians(SUN_AZIMUTH_DEGREES);
        var towards = new Vec3(Math.cos(up) * Math.sin(aside), Math.sin(up), -Math.cos(up) * Math.cos(aside));
        return environment.with(TableCase.SKY).with(new Sun(towards, TableCase.SUN_IRRADIANCE, true));
    }

    /** Returns the view of a layer from below, farther away and from a hill, of a finite cloud from three distances. */
    private static View autoView(Cloud first, int place) {
        double aspect = (double) SkyView.WIDTH / SkyView.HEIGHT;
        if (first.extent() instanceof Cloud.Extent.Volume volume) {
            Vec3 middle = volume.centre();
            double away = new double[] {1, 0.6, 2.2}[place];
            double aside = new double[] {0, 0.5, -0.4}[place];
            double far = Math.hypot(middle.x(), middle.z());
            var eye = new Vec3(middle.x() + aside * far, 2, middle.z() + away * far);
            double radius = volume.size().length() / 2;
            double fov = Math.toDegrees(
                    2 * Math.atan(1.2 * radius / middle.minus(eye).length()));
            return Viewpoints.between(eye, middle, fov, aspect);
        }
        Vec3 eye = List.of(new Vec3(0, 2, 0), new Vec3(5200, 2, -3100), new Vec3(-2400, 120, 900))
                .get(place);
        Vec3 ahead = List.of(new Vec3(0, 0.5, -1), new Vec3(0.6, 1.2, 0.8), new Vec3(-1, 0.3, 0.2))
                .get(place);
        return Viewpoints.between(eye, eye.plus(ahead.scaled(1000)), 75.0, aspect);
    }
}
