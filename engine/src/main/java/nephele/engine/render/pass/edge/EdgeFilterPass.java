package nephele.engine.render.pass.edge;

import java.util.List;
import java.util.Set;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.FullScreenDrawing;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.Quality.Antialiasing;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.TextureUnit;

/**
 * Smooths stairs along edges of the displayed picture, before it is scaled up and before anything is written over it;
 * exists only if quality requests it.
 */
public final class EdgeFilterPass implements Pass {
    public static final RenderFeature FEATURE =
            new RenderFeature("edge-filter", Stage.AFTER_ALL, EdgeFilterPass::requiredBy);

    private static final String FOLDER = "/nephele/engine/render/pass/edge/";

    private final LoadContext context;
    /** The edges of a picture, a texel a pixel; {@code null} before the first one. */
    private RenderTarget edges;

    private final FullScreenDrawing find;
    private final FullScreenDrawing copy;
    private final FullScreenDrawing smooth;

    private EdgeFilterPass(LoadContext context) {
        this.context = context;
        context.own(this::closeEdges);
        find = drawing(context, "full.vert", "edges.frag");
        copy = drawing(context, "full.vert", "copy.frag");
        smooth = drawing(context, "smooth.vert", "smooth.frag");
    }

    private static FullScreenDrawing drawing(LoadContext context, String vertex, String fragment) {
        return new FullScreenDrawing(context, new Defines(), FOLDER + vertex, FOLDER + fragment);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.quality().antialiasing() != Antialiasing.MORPHOLOGICAL || !request.drawsSomething()
                ? List.of()
                : List.of(new Required("quality: antialiasing", EdgeFilterPass::new));
    }

    @Override
    public Set<Target> reads() {
        return Set.of(Target.SURFACE);
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.PICTURE);
    }

    @Override
    public void draw(FrameContext frame) {
        RenderTarget picture = frame.surface();
        if (edges == null || edges.width() != picture.width() || edges.height() != picture.height()) {
            closeEdges();
            edges = RenderTarget.picture(context.gl(), "edges", PixelFormat.RGBA8, picture.width(), picture.height());
        }
        picture.colour().bind(TextureUnit.COLOURS);
        find.draw(edges, Depth.OFF);
        edges.colour().bind(TextureUnit.EDGES);
        RenderTarget written = frame.picture();
        written.clear(0, 0, 0);
        copy.draw(written, Depth.LESS_AND_WRITE);
        smooth.draw(written, Depth.LESS_AND_WRITE);
    }

    private void closeEdges() {
        if (edges != null) {
            edges.close();
        }
    }
}
