package nephele.engine.render;

import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;

/**
 * The pictures between the views and the final picture: each pass after all views reads one and writes the next. They
 * have the share of the final picture's pixels that quality decides; the last pass then scales them up.
 */
final class PictureChain implements AutoCloseable {
    private final GlContext gl;
    private final double resolution;
    private final RenderTarget[] before;
    private final PixelFormat[] formats;
    private final boolean isLinear;

    /**
     * Creates a chain without pictures.
     *
     * @param passes number of passes after all views; without one, views are drawn into the final picture
     */
    PictureChain(GlContext gl, FrameRequest request, int passes) {
        this.gl = gl;
        resolution = request.quality().pictureResolution();
        isLinear = request.output() == Output.HDR;
        before = new RenderTarget[passes];
        formats = new PixelFormat[passes];
        for (int i = 0; i < passes; i++) {
            formats[i] = i == 0 && isLinear || request.storesDistance() ? PixelFormat.RGBA16F : PixelFormat.RGBA8;
        }
    }

    /** Returns the target of the views of a frame that ends in {@code picture}. */
    RenderTarget surface(RenderTarget picture) {
        return before(0, picture);
    }

    /** Returns the target that a pass after all views reads, or {@code picture} beyond the last pass. */
    RenderTarget before(int pass, RenderTarget picture) {
        if (pass == before.length) {
            return picture;
        }
        int width = pixels(picture.width());
        int height = pixels(picture.height());
        RenderTarget known = before[pass];
        if (known == null || known.width() != width || known.height() != height) {
            close(pass);
            before[pass] = RenderTarget.picture(
                    gl, "picture before pass " + pass, formats[pass], width, height, Sampling.LINEAR_CLAMP);
        }
        return before[pass];
    }

    private int pixels(int ofPicture) {
        return Math.max(1, (int) Math.round(resolution * ofPicture));
    }

    /** Returns RGB of the views, the bottom row first. */
    float[] readRadiance() {
        return radiance().readFloats();
    }

    /** Returns the linear picture of the views. */
    RenderTarget radiance() {
        if (before.length == 0 || before[0] == null || !isLinear) {
            throw new IllegalStateException("radiance can be read after a frame with output HDR");
        }
        return before[0];
    }

    private void close(int pass) {
        if (before[pass] != null) {
            before[pass].close();
            before[pass] = null;
        }
    }

    @Override
    public void close() {
        for (int i = 0; i < before.length; i++) {
            close(i);
        }
    }
}
