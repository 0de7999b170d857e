package nephele.engine.render.pass.edge;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Texture;

/** The edges of a picture, a texel a pixel. */
final class EdgePicture implements GlObject {
    private final GlContext gl;
    private RenderTarget target;

    EdgePicture(GlContext gl) {
        this.gl = gl;
    }

    RenderTarget ofSizeOf(RenderTarget picture) {
        if (target == null || target.width() != picture.width() || target.height() != picture.height()) {
            close();
            target = RenderTarget.picture(gl, "edges", PixelFormat.RGBA8, picture.width(), picture.height());
        }
        return target;
    }

    Texture colour() {
        return target.colour();
    }

    @Override
    public void close() {
        if (target != null) {
            target.close();
            target = null;
        }
    }
}
