package nephele.engine.render;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;

/** A context with one small 8-bit picture; every frame is checked for OpenGL errors. */
public final class Offscreen implements AutoCloseable {
    public final GlContext gl = GlContext.offscreen();
    public final RenderTarget picture;

    public Offscreen(int width, int height) {
        picture = RenderTarget.picture(gl, "test picture", PixelFormat.RGBA8, width, height);
    }

    /** Returns 0xrrggbb, the bottom row first. */
    int[] pixels(Level level, View view, Output output) {
        return pixels(level, TestAssets.NONE, view, RenderSettings.of(output));
    }

    public int[] pixels(Level level, AssetSource assets, View view, RenderSettings settings) {
        try (Renderer renderer = LevelRenderer.load(gl, level, assets, settings)) {
            renderer.draw(view, picture);
            gl.requireNoError("test frame");
            return pixels();
        }
    }

    public int[] pixels() {
        return pixels(picture);
    }

    static int[] pixels(RenderTarget target) {
        ByteBuffer bytes = target.readBytes();
        int[] rgb = new int[target.width() * target.height()];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (bytes.get(4 * i) & 0xff) << 16 | (bytes.get(4 * i + 1) & 0xff) << 8 | bytes.get(4 * i + 2) & 0xff;
        }
        return rgb;
    }

    /** Returns linear RGB, the bottom row first. */
    public float[] radiance(Level level, AssetSource assets, View view) {
        return radiance(level, assets, List.of(view)).get(0);
    }

    /** Returns the radiance of each view, drawn by one renderer without history. */
    public List<float[]> radiance(Level level, AssetSource assets, List<View> views) {
        return radiance(level, assets, views, Quality.HIGH);
    }

    /** Returns the radiance of some views, drawn with a quality. */
    public List<float[]> radiance(Level level, AssetSource assets, List<View> views, Quality quality) {
        try (Renderer renderer = LevelRenderer.load(gl, level, assets, RenderSettings.of(Output.HDR, quality))) {
            List<float[]> seen = new ArrayList<>();
            for (View view : views) {
                renderer.forget();
                renderer.draw(view, picture);
                gl.requireNoError("test frame");
                seen.add(renderer.readRadiance());
            }
            return seen;
        }
    }

    /** Returns a view with a 90° vertical field of view. */
    public View view(Vec3 eye, Vec3 target) {
        double aspect = picture.width() / (double) picture.height();
        return View.lookAt(eye, target, new Vec3(0, 1, 0), new Projection(Math.PI / 2, aspect, 0.05, 1000));
    }

    /** Returns the unit direction of a pixel's ray; the first pixel is the lower left one. */
    public Vec3 ray(View view, int pixel) {
        double x = (2 * (pixel % picture.width()) + 1.0) / picture.width() - 1;
        double y = (2 * (pixel / picture.width()) + 1.0) / picture.height() - 1;
        Vec3 towards = view.right()
                .scaled(x * view.projection().tanHalfWidth())
                .addScaled(y * view.projection().tanHalfHeight(), view.up())
                .addScaled(-1, view.back());
        return towards.scaled(1 / towards.length());
    }

    public static int red(int rgb) {
        return rgb >> 16;
    }

    public static int green(int rgb) {
        return rgb >> 8 & 0xff;
    }

    public static int blue(int rgb) {
        return rgb & 0xff;
    }

    @Override
    public void close() {
        picture.close();
        gl.close();
    }
}
