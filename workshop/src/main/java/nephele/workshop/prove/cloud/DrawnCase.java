package nephele.workshop.prove.cloud;

import java.util.List;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.measure.ImageError;
import nephele.engine.measure.LinearPicture;
import nephele.engine.measure.Stopwatch;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.CloudHistory;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.light.LevelLight;

/**
 * A case as the engine draws it: each pixel of its picture is the mean of a square of drawn ones, as it is a mean of traced
 * paths. Pixels whose middle ray has an optical depth above {@value #LEAST_DEPTH} count.
 */
final class DrawnCase {
    private static final double LEAST_DEPTH = 0.01;

    /** How far rays are followed through endless clouds, metres. */
    private static final double FAR = 200_000;

    private final ReferenceCase exact;
    private final int side;
    private final boolean[] counts;

    /** @param side of the square of pixels that are drawn for each */
    DrawnCase(ReferenceCase exact, int side) {
        this.exact = exact;
        this.side = side;
        counts = cloudy(exact);
    }

    private int pixels() {
        int count = 0;
        for (boolean one : counts) {
            count += one ? 1 : 0;
        }
        return count;
    }

    /** Returns the standard error of the exact picture's pixels, root mean square, divided by their mean. */
    double noise() {
        var none = new LinearPicture(
                exact.error().width(),
                exact.error().height(),
                new float[exact.error().rgb().length]);
        return ImageError.rootMeanSquare(none, exact.error(), counts) / mean(exact.radiance());
    }

    private double mean(LinearPicture picture) {
        double sum = 0;
        for (int i = 0; i < picture.rgb().length; i++) {
            sum += counts[i / 3] ? picture.rgb()[i] : 0;
        }
        return sum / (3 * pixels());
    }

    /** A renderer of the case with one model of light, and the picture that it draws. */
    final class Drawing implements AutoCloseable {
        private final GlContext gl;
        private final RenderTarget target;
        private final Renderer renderer;
        private final LinearPicture picture;

        Drawing(GlContext gl, CloudScattering model) {
            this.gl = gl;
            Quality quality = Quality.HIGH
                    .with("cloudResolution", 1)
                    .with("cloudHistory", CloudHistory.NONE)
                    .with("cloudScattering", model);
            Scene scene = Scene.of(exact.placed(), LevelLight.of(exact.placed(), done -> {}));
            renderer = LevelRenderer.load(gl, scene, RenderSettings.of(Output.HDR, quality));
            LinearPicture size = exact.radiance();
            target = RenderTarget.picture(
                    gl, "cloud case", PixelFormat.RGBA8, side * size.width(), side * size.height());
            draw(1);
            picture = new LinearPicture(target.width(), target.height(), renderer.readRadiance()).reduced(side);
        }

        /** Returns the difference of the mean radiance, over the pixels that count, as a fraction of the exact one. */
        double bias() {
            return mean(picture) / mean(exact.radiance()) - 1;
        }

        /** Returns the root mean square of the differences, over the pixels that count, divided by the exact mean. */
        double rootMeanSquare() {
            return ImageError.rootMeanSquare(exact.radiance(), picture, counts) / mean(exact.radiance());
        }

        /** Returns the CPU time of the process for some frames. */
        long nanos(int frames, Stopwatch watch) {
            long before = watch.processCpuNanos();
            draw(frames);
            return watch.processCpuNanos() - before;
        }

        private void draw(int frames) {
            for (int frame = 0; frame < frames; frame++) {
                renderer.draw(exact.view(), target);
            }
            gl.finish();
            gl.requireNoError("cloud case");
        }

        @Override
        public void close() {
            renderer.close();
            target.close();
        }
    }

    private static boolean[] cloudy(ReferenceCase scene) {
        List<CloudMedium> media = LoadedClouds.of(
                        scene.placed().level().environment(), scene.placed().assets())
                .at(0);
        int width = scene.radiance().width();
        int height = scene.radiance().height();
        boolean[] cloudy = new boolean[width * height];
        for (int pixel = 0; pixel < cloudy.length; pixel++) {
            Ray ray = middle(scene.view(), (pixel % width + 0.5) / width, (pixel / width + 0.5) / height);
            double depth = 0;
            for (CloudMedium medium : media) {
                depth += OpticalDepth.quadrature(medium.field(), ray, 0, FAR, 1);
            }
            cloudy[pixel] = depth > LEAST_DEPTH;
        }
        return cloudy;
    }

    /** @param right 0 at the left border, 1 at the right one; {@code up} likewise from the bottom */
    private static Ray middle(View view, double right, double up) {
        double x = (2 * right - 1) * view.projection().tanHalfWidth();
        double y = (2 * up - 1) * view.projection().tanHalfHeight();
        Vec3 along = view.back().negated().addScaled(x, view.right()).addScaled(y, view.up());
        return Ray.of(view.eye(), along.scaled(1 / along.length()));
    }
}
