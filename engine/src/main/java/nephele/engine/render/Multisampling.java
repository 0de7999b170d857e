package nephele.engine.render;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/**
 * Draws surfaces with several coverage samples a pixel and averages them. If OpenGL cannot, or if one sample is
 * requested, surfaces are drawn directly into their target, except for a window whose pixels are read.
 */
final class Multisampling implements AutoCloseable {
    private final GlContext gl;
    private final int samples;
    private final boolean isRead;
    private RenderTarget many;
    private RenderTarget averaged;
    private PixelFormat format;
    private int width;
    private int height;

    /** @param isRead true if passes read copies of the target, which a window does not permit */
    Multisampling(GlContext gl, int samples, boolean isRead) {
        this.gl = gl;
        this.isRead = isRead;
        this.samples = Math.min(samples, gl.limits().maxSamples());
    }

    /** Returns x and y of each sample of a pixel, pixels from the pixel's centre. */
    float[] positions() {
        return RenderTarget.samplePositions(gl, samples);
    }

    /**
     * Returns the target to draw into instead of {@code surface}: itself if its pixels have one sample and can be
     * copied.
     */
    RenderTarget inPlaceOf(RenderTarget surface, PixelFormat surfaceFormat) {
        boolean isHidden = isRead && surface.isWindow();
        if (samples <= 1 && !isHidden) {
            return surface;
        }
        if (width != surface.width() || height != surface.height() || format != surfaceFormat) {
            close();
            width = surface.width();
            height = surface.height();
            format = surfaceFormat;
            many = samples <= 1 ? null : RenderTarget.multisampled(gl, format, width, height, samples);
        }
        if (many == null && isHidden) {
            many = RenderTarget.picture(gl, "surface", format, width, height);
        }
        return many == null ? surface : many;
    }

    /** Copies the drawn picture to {@code surface} if it was drawn elsewhere. */
    void resolve(RenderTarget surface) {
        if (many == null) {
            return;
        }
        if (surface.colour() != null || many.colour() != null) {
            many.copyTo(surface);
            return;
        }
        // Samples can only be averaged into the same format, and the system chooses that of a window.
        if (averaged == null) {
            averaged = RenderTarget.picture(gl, "averaged samples", format, width, height);
        }
        many.copyTo(averaged);
        averaged.copyTo(surface);
    }

    @Override
    public void close() {
        if (many != null) {
            many.close();
            many = null;
        }
        if (averaged != null) {
            averaged.close();
            averaged = null;
        }
    }
}
