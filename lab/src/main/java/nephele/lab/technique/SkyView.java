package nephele.lab.technique;

import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.level.Camera;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.scene.View;
import nephele.lab.bake.TracedPictures;

/**
 * A sky with clouds, seen from a place.
 *
 * @param level without surfaces in front of its clouds
 */
public record SkyView(Level level, AssetSource assets, View view) {
    /** Size of its pictures, pixels. */
    public static final int WIDTH = 40;

    public static final int HEIGHT = 24;

    private static final double NEAR = 0.1;

    private static final double LEAST_DEPTH = 0.01;
    /** How far rays are followed through endless clouds, metres. */
    private static final double FAR = 200_000;

    /** Returns a sky alone, in a level whose camera is where it is seen from: skyboxes are baked from there. */
    public static SkyView alone(String name, Environment environment, AssetSource assets, View view) {
        Vec3 ahead = view.eye().minus(view.back());
        var camera = new Camera("eye", view.eye(), ahead, view.up(), 0, 0, NEAR, FAR, List.of());
        return new SkyView(Level.of(name, "", environment, List.of(camera)), assets, view);
    }

    /** Returns the level with all its clouds drawn by a technique. */
    public PlacedLevel drawnBy(CloudTechnique technique) {
        return PlacedLevel.of(
                level.with(WeatherClouds.drawnBy(level.environment(), technique), level.lights()), assets);
    }

    /** Returns traced radiance, bottom row first. */
    LinearPicture traced(int samples, long seed) {
        int threads = Runtime.getRuntime().availableProcessors();
        var settings = new TraceSettings(WIDTH, HEIGHT, samples, seed, threads);
        var traced = TracedLevel.of(PlacedLevel.of(level, assets), ColourDecoding.SRGB);
        return new LinearPicture(
                WIDTH, HEIGHT, ReferencePicture.trace(traced, TracedPictures.pinhole(view), settings, done -> {}));
    }

    /** Returns for each pixel whether the ray through its middle has an optical depth above 0.01. */
    boolean[] cloudy() {
        List<CloudMedium> media = LoadedClouds.of(level.environment(), assets).at(0);
        boolean[] cloudy = new boolean[WIDTH * HEIGHT];
        for (int pixel = 0; pixel < cloudy.length; pixel++) {
            Ray ray = middle((pixel % WIDTH + 0.5) / WIDTH, (pixel / WIDTH + 0.5) / HEIGHT);
            double depth = 0;
            for (CloudMedium medium : media) {
                depth += OpticalDepth.quadrature(medium.field(), ray, 0, FAR, 1);
            }
            cloudy[pixel] = depth > LEAST_DEPTH;
        }
        return cloudy;
    }

    private Ray middle(double right, double up) {
        double x = (2 * right - 1) * view.projection().tanHalfWidth();
        double y = (2 * up - 1) * view.projection().tanHalfHeight();
        Vec3 along = view.back().negated().addScaled(x, view.right()).addScaled(y, view.up());
        return Ray.of(view.eye(), along.scaled(1 / along.length()));
    }
}
