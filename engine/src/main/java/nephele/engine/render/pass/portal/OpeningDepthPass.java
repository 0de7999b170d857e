package nephele.engine.render.pass.portal;

import java.util.List;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.ViewNode;

/** Writes the depth of openings first, so that neither their wall nor what is behind it is drawn there. */
public final class OpeningDepthPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "portal.depth",
                    Stage.IN_VIEWS,
                    request ->
                            Required.ofOpenings(request, "where openings hide what is behind", OpeningDepthPass::new))
            .using(OpeningMesh.RESOURCE);

    private final GlContext gl;
    private final GlProgram<?> program;
    private final OpeningMesh openings;

    private OpeningDepthPass(LoadContext context) {
        gl = context.gl();
        program = PortalPass.nothing(context);
        openings = context.get(OpeningMesh.RESOURCE);
    }

    @Override
    public void draw(FrameContext frame) {
        List<ViewNode> children = frame.node().children();
        if (children.isEmpty()) {
            return;
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_AND_WRITE_ONLY_DEPTH, Blend.REPLACE, Cull.NONE);
        program.use();
        for (int i = 0; i < children.size(); i++) {
            gl.state().depthOf(OpeningMesh.depthOf(children.get(i)));
            openings.draw(children.get(i));
        }
        gl.state().depthOf(DepthOf.SURFACE);
    }
}
