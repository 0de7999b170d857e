package nephele.engine.render;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;

/** The linear radiance of a frame in output HDR; has the size of the picture into which it is tone-mapped. */
final class LinearTarget implements AutoCloseable {
    private final GlContext gl;
    private RenderTarget target;

    LinearTarget(GlContext gl) {
        this.gl = gl;
    }

    RenderTarget ofSizeOf(RenderTarget picture) {
        if (target == null || target.width() != picture.width() || target.height() != picture.height()) {
            close();
            target = RenderTarget.picture(gl, "linear picture", PixelFormat.RGBA16F, picture.width(), picture.height());
        }
        return target;
    }

    /** Returns RGB, the bottom row first. */
    float[] read() {
        if (target == null) {
            throw new IllegalStateException("radiance can be read after a frame with output HDR");
        }
        return target.readFloats();
    }

    @Override
    public void close() {
        if (target != null) {
            target.close();
            target = null;
        }
    }
}
