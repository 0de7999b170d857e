package nephele.lab.trade.subject;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.lab.trade.TradeSite;

/**
 * Successive views of a level that does not change, and the size of their pictures.
 *
 * @param width pixels
 * @param height pixels
 */
record Footage(List<View> views, int width, int height) {
    /** Linear light of each sRGB code. */
    private static final double[] DISPLAYED_LIGHT = IntStream.range(0, 256)
            .mapToDouble(code -> ToneMapping.decodeSrgb(code / 255.0))
            .toArray();

    /** The number of frames along a path. */
    static final int PATH_FRAMES = 8;

    /** The largest picture along a path. */
    static final int PATH_WIDTH = 320;

    static final int PATH_HEIGHT = 180;

    /** The picture's motion from frame to frame: 0.3 pixels, oblique, so that edges of all directions move. */
    private static final double PIXELS_RIGHTWARDS = 0.24;

    private static final double PIXELS_UPWARDS = 0.18;

    /** The eye's way from frame to frame of a flight. */
    private static final double FLIGHT_METRES = 16;

    /** The eye's way from frame to frame of a run: 6 m/s at 60 frames a second. */
    private static final double RUN_METRES = 0.1;

    static Footage still(TradeSite site) {
        return new Footage(
                List.of(site.view()), site.extent().width(), site.extent().height());
    }

    /** Returns a path on which the site's view turns by 0.3 pixels a frame. */
    static Footage path(TradeSite site) {
        return small(
                site,
                (frame, pixel) ->
                        turned(site.view(), frame * PIXELS_RIGHTWARDS * pixel, frame * PIXELS_UPWARDS * pixel));
    }

    /** Returns a path on which the site's eye moves to the right by 16 m a frame. */
    static Footage flight(TradeSite site) {
        return sideways(site, FLIGHT_METRES);
    }

    /** Returns a path on which the site's eye moves to the right by 0.1 m a frame. */
    static Footage run(TradeSite site) {
        return sideways(site, RUN_METRES);
    }

    private static Footage sideways(TradeSite site, double metres) {
        View view = site.view();
        return small(
                site,
                (frame, pixel) -> new View(
                        view.eye().addScaled(frame * metres, view.right()),
                        view.right(),
                        view.up(),
                        view.back(),
                        view.projection(),
                        view.clip()));
    }

    /** @param viewOf the number of a frame and the size of a pixel at distance 1 */
    private static Footage small(TradeSite site, BiFunction<Integer, Double, View> viewOf) {
        var extent = site.extent();
        double scale =
                Math.min(1, Math.min((double) PATH_WIDTH / extent.width(), (double) PATH_HEIGHT / extent.height()));
        int width = (int) Math.max(1, Math.round(scale * extent.width()));
        int height = (int) Math.max(1, Math.round(scale * extent.height()));
        double pixel = 2 * site.view().projection().tanHalfHeight() / height;
        var views = IntStream.range(0, PATH_FRAMES)
                .mapToObj(frame -> viewOf.apply(frame, pixel))
                .toList();
        return new Footage(views, width, height);
    }

    /** Returns the view whose middle is at a point of the picture's plane at distance 1. */
    private static View turned(View view, double rightwards, double upwards) {
        Vec3 direction =
                view.back().negated().addScaled(rightwards, view.right()).addScaled(upwards, view.up());
        Basis basis = Basis.lookAt(Vec3.ZERO, direction, view.up(), Basis.WORLD);
        return new View(view.eye(), basis.right(), basis.up(), basis.back(), view.projection(), view.clip());
    }

    /**
     * Draws the views in order, the first one until it has settled, and returns the displayed light.
     *
     * @param side of the square of pixels that are drawn for each pixel, and averaged
     */
    List<LinearPicture> displayed(GlContext gl, Renderer renderer, int side) {
        List<LinearPicture> frames = new ArrayList<>();
        try (var picture = RenderTarget.picture(gl, "footage", PixelFormat.RGBA8, side * width, side * height)) {
            for (int frame = 1; frame < PictureExperiment.SETTLING_FRAMES; frame++) {
                renderer.draw(views.get(0), picture);
            }
            for (View view : views) {
                renderer.draw(view, picture);
                frames.add(displayedLight(picture.readBytes(), width, height, side));
            }
        }
        gl.requireNoError("footage");
        return frames;
    }

    /**
     * Returns the mean linear light of boxes of {@code side} by {@code side} pixels.
     *
     * @param rgba the codes, four a pixel, row by row
     * @param width of the result
     * @param height of the result
     */
    static LinearPicture displayedLight(ByteBuffer rgba, int width, int height, int side) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            int column = i / 3 % width;
            int row = i / 3 / width;
            double sum = 0;
            for (int y = row * side; y < (row + 1) * side; y++) {
                for (int x = column * side; x < (column + 1) * side; x++) {
                    sum += DISPLAYED_LIGHT[rgba.get(4 * (y * width * side + x) + i % 3) & 0xff];
                }
            }
            rgb[i] = (float) (sum / (side * side));
        }
        return new LinearPicture(width, height, rgb);
    }
}
