package nephele.engine.cloud.field;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;
import java.util.stream.IntStream;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Weather;
import nephele.engine.level.appearance.CloudDemand;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.appearance.WeatherClouds.ChangingCloud;
import nephele.engine.level.appearance.WeatherCourse;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * All clouds of an environment, those of its weather included, with their pictures, grids and tables; clouds with the
 * same seed share their tables. Immutable.
 */
public final class LoadedClouds {
    /** Columns along x and z by which the light on the plain is found. */
    private static final int COLUMNS_ACROSS = 13;

    private static final double COLUMN_SPACING_METRES = 1500;
    private static final int COLUMN_ROWS = 16;
    private static final double LEAST_SUN_SINE = 0.05;

    private final List<CloudFields> loaded;
    private final List<Cloud> clouds;
    private final List<Weather> weathers;
    private final WeatherCourse course;
    private final boolean isRound;

    private LoadedClouds(List<CloudFields> loaded, List<Weather> weathers, WeatherCourse course, boolean isRound) {
        this.loaded = List.copyOf(loaded);
        clouds = loaded.stream().map(CloudFields::cloud).toList();
        this.weathers = weathers;
        this.course = course;
        this.isRound = isRound;
    }

    /**
     * Loads the clouds of an environment. Under a sky of kind atmosphere, layers are shells around the planet.
     *
     * @throws AssetException if a picture or grid is unusable
     */
    public static LoadedClouds of(Environment environment, AssetSource assets) throws AssetException {
        Map<Long, CloudTables> known = new HashMap<>();
        return of(environment, assets, seed -> known.computeIfAbsent(seed, CloudTables::of));
    }

    /**
     * Loads clouds with given tables.
     *
     * @param tables makes or remembers the tables of a seed
     * @throws AssetException if a picture or grid is unusable, or memory does not suffice
     */
    public static LoadedClouds of(Environment environment, AssetSource assets, LongFunction<CloudTables> tables)
            throws AssetException {
        List<ChangingCloud> changing = WeatherClouds.changing(environment);
        List<Cloud> clouds = changing.stream().map(ChangingCloud::cloud).toList();
        CloudDemand.of(clouds).requireMemoryOfTables(Runtime.getRuntime().maxMemory());
        List<Weather> weathers = new ArrayList<>();
        changing.forEach(cloud -> weathers.add(cloud.weather()));
        List<CloudFields> loaded = new ArrayList<>();
        for (Cloud cloud : clouds) {
            loaded.add(CloudFields.of(cloud, assets, tables));
        }
        return new LoadedClouds(
                loaded, weathers, WeatherCourse.of(environment), environment.sky() instanceof Sky.Atmosphere);
    }

    /** Returns the clouds, those of the weather last. */
    public List<Cloud> clouds() {
        return clouds;
    }

    /** Returns the same clouds without wind: as an observer sees them who drifts with each. */
    public LoadedClouds withoutWind() {
        List<CloudFields> still = loaded.stream().map(LoadedClouds::withoutWind).toList();
        return new LoadedClouds(still, weathers, course, isRound);
    }

    private static CloudFields withoutWind(CloudFields loaded) {
        Cloud cloud = loaded.cloud();
        return loaded.with(cloud.with(new Cloud.Motion(Vec3.ZERO, cloud.motion().evolutionSeconds())));
    }

    /**
     * Returns the same clouds, each drawn by its technique of a list.
     *
     * @param techniques as many as clouds
     */
    public LoadedClouds drawnBy(List<CloudTechnique> techniques) {
        List<CloudFields> drawn = new ArrayList<>();
        for (int i = 0; i < clouds.size(); i++) {
            drawn.add(loaded.get(i).with(clouds.get(i).with(techniques.get(i))));
        }
        return new LoadedClouds(drawn, weathers, course, isRound);
    }

    /** Returns the field that a cloud has at the start in a world without curvature, if its weather has come wholly. */
    public ExtinctionField flat(int index) {
        return loaded.get(index).flat(0, 0);
    }

    /** Returns the field that a cloud has at some time if its weather has come wholly. */
    public ExtinctionField field(int index, double seconds) {
        return field(loaded.get(index), seconds);
    }

    /** Returns the fraction of a cloud's extinction that its weather gives it at a time, 0 to 1. */
    public double presence(int index, double seconds) {
        Weather weather = weathers.get(index);
        return weather == null ? 1 : course.weight(weather, seconds);
    }

    /** Returns the weather over time. */
    public WeatherCourse course() {
        return course;
    }

    private CloudFields present(int index, double seconds) {
        double presence = presence(index, seconds);
        Cloud cloud = clouds.get(index);
        CloudFields whole = loaded.get(index);
        return presence == 1 ? whole : whole.with(cloud.withExtinction(presence * cloud.extinctionPerMetre()));
    }

    /**
     * Returns the clouds' media in their order.
     *
     * @param seconds simulated time
     */
    public List<CloudMedium> at(double seconds) {
        List<CloudMedium> media = new ArrayList<>();
        for (int i = 0; i < clouds.size(); i++) {
            media.add(CloudMedium.of(clouds.get(i), field(present(i, seconds), seconds)));
        }
        return List.copyOf(media);
    }

    /**
     * Returns the fraction of its light that the clouds leave the plain around a place, on the mean: what the ground throws
     * back at them. Columns are independent slabs after Eddington (Shettle and Weinman 1970), with τ (1 − ω g) for their depth.
     *
     * @param seconds simulated time
     * @param sunSine of the sun's elevation
     * @param groundAlbedo of the plain
     */
    public double groundFraction(double seconds, Vec3 place, double sunSine, double groundAlbedo) {
        List<ExtinctionField> fields = new ArrayList<>();
        for (int i = 0; i < clouds.size(); i++) {
            fields.add(present(i, seconds).flat(seconds, 0));
        }
        double mu = Math.max(LEAST_SUN_SINE, sunSine);
        double transmitted = 0;
        double diffuse = 0;
        int count = COLUMNS_ACROSS * COLUMNS_ACROSS;
        for (int n = 0; n < count; n++) {
            double x = place.x() + (n % COLUMNS_ACROSS - COLUMNS_ACROSS / 2) * COLUMN_SPACING_METRES;
            double z = place.z() + (n / COLUMNS_ACROSS - COLUMNS_ACROSS / 2) * COLUMN_SPACING_METRES;
            double depth = IntStream.range(0, fields.size())
                    .mapToDouble(i -> isotropicDepth(loaded.get(i), fields.get(i), seconds, x, z))
                    .sum();
            double left = StrictMath.exp(-depth / mu);
            transmitted += (2.0 / 3 + mu + (2.0 / 3 - mu) * left) / (4.0 / 3 + depth) / count;
            diffuse += 1 / (1 + 0.75 * depth) / count;
        }
        return transmitted / (1 - groundAlbedo * (1 - diffuse));
    }

    /** Returns the vertical depth of a column of a cloud, as isotropic scattering of the same effect. */
    private static double isotropicDepth(
            CloudFields loaded, ExtinctionField field, double seconds, double x, double z) {
        Aabb bounds = loaded.bounds(seconds);
        double base = bounds.minY();
        double row = (bounds.maxY() - base) / COLUMN_ROWS;
        double sum = 0;
        for (int j = 0; j < COLUMN_ROWS; j++) {
            sum += field.perMetre(x, base + (j + 0.5) * row, z) * row;
        }
        return sum
                * (1 - loaded.cloud().albedo() * CloudOptics.of(loaded.cloud()).meanCosine());
    }

    private ExtinctionField field(CloudFields loaded, double seconds) {
        boolean isShell = isRound
                && loaded.cloud().extent() instanceof Cloud.Extent.Layer
                && !(loaded.cloud().density() instanceof Cloud.Density.Puffs);
        return isShell ? new ShellField(loaded.flat(seconds, ShellField.SLACK_METRES)) : loaded.flat(seconds, 0);
    }
}
