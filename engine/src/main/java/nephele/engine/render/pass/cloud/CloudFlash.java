package nephele.engine.render.pass.cloud;

import nephele.engine.lightning.Bolt;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.FrameLightning;

/**
 * The light of lightning in clouds, which is added to the picture of the clouds: a flash changes from frame to frame, so it
 * takes nothing from earlier ones. It has a layer of its own, and a row with what clouds hide of each point of the bolt.
 * Between flashes nothing is drawn.
 */
final class CloudFlash {
    /** Least number of pixels of the view along each side of one of the layer: scattered light is smooth. */
    private static final int LEAST_DIVISOR = 6;

    private final GlContext gl;
    private final FrameLightning lightning;
    private final CloudLayer layer;
    private final RenderTarget row;
    private final DrawState.Limits limits = new DrawState.Limits();

    /** @param clouds number of bounds that programs know */
    CloudFlash(LoadContext context, int divisorOfClouds, int clouds) {
        gl = context.gl();
        lightning = context.get(FrameLightning.RESOURCE);
        layer = context.own(new CloudLayer(context, Math.max(LEAST_DIVISOR, divisorOfClouds), 1, clouds));
        row = context.own(
                RenderTarget.picture(gl, "transmittance of a bolt", PixelFormat.RGBA16F, Bolt.MOST_POINTS, 1));
        row.clear(1, 1, 1);
        context.targets().put(Target.BOLT_TRANSMITTANCE, row.colour());
    }

    boolean isLit() {
        return lightning.isLit();
    }

    CloudLayer layer() {
        return layer;
    }

    /** Begins the row of a view: each point is seen whole. */
    void beginBolt() {
        gl.state().beginLayer(1, limits);
        gl.state().noScissor();
        row.clear(1, 1, 1);
        row.bind();
        lightning.bindPoints(TextureUnit.BOLT_POINTS);
    }

    void endBolt() {
        gl.state().endLayer(limits);
    }

    /**
     * Adds the layer to the surfaces of a view.
     *
     * @param ranges of the clouds, if surfaces can be among them and hide some; otherwise {@code null}
     */
    void add(FrameContext frame, CloudRanges ranges, FullScreenTriangle triangle) {
        frame.surface().bind();
        layer.draw(Blend.ADD, triangle);
        if (ranges != null) {
            layer.drawOverSurfaces(Blend.ADD, ranges, frame.view(), triangle);
        }
    }
}
