package nephele.engine.render.pass.cloud.volume;

import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Pixels;

/** The target of low resolution into which clouds are marched; views of one size share it in turn. */
final class CloudLayer implements GlObject {
    private final GlContext gl;
    private final int divisor;
    private final MarchPrograms programs;
    private final DrawState.Limits limits = new DrawState.Limits();
    private RenderTarget target;
    private int width;
    private int height;

    /** @param divisor pixels of the view along each side of one of the layer */
    CloudLayer(LoadContext context, int divisor) {
        gl = context.gl();
        this.divisor = divisor;
        programs = new MarchPrograms(context, Pixels.WHOLE, 0);
    }

    MarchPrograms programs() {
        return programs;
    }

    /** Sets how far the layer reaches. */
    void put(Uniforms.Vector2 reach) {
        reach.set((float) (divisor * target.width()) / width, (float) (divisor * target.height()) / height);
    }

    /** Begins the layer of a view, empty. */
    void begin(RenderTarget surface) {
        if (target == null || width != surface.width() || height != surface.height()) {
            close();
            width = surface.width();
            height = surface.height();
            target = surface.reduced("clouds", PixelFormat.RGBA16F, divisor);
        }
        gl.state().beginLayer(divisor, limits);
        target.clearTransparentWithinScissor();
    }

    /** Ends it and restores the limits of the view. */
    void end() {
        gl.state().endLayer(limits);
    }

    int divisor() {
        return divisor;
    }

    void bindPicture() {
        target.colour().bind(TextureUnit.COLOURS);
    }

    @Override
    public void close() {
        if (target != null) {
            target.close();
            target = null;
        }
    }
}
