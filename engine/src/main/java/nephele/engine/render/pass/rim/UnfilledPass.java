package nephele.engine.render.pass.rim;

import java.util.List;
import java.util.Map;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.NestedViews.Filling;
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
import nephele.engine.render.pass.rim.RimLook.PortalUniforms;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.Opening;
import nephele.engine.scene.ViewNode;

/**
 * Draws a membrane over each opening that the frame's views do not reach and no previous picture fills, as in the first
 * frame. The sky behind is visible through it, so that it nowhere shows a single colour. It is no decoration: the
 * opening exists with or without rims.
 */
public final class UnfilledPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "portal.unfilled", Stage.IN_VIEWS, UnfilledPass::requiredBy)
            .using(OpeningMesh.RESOURCE, MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/rim/";
    /** The background is visible through a membrane. */
    private static final double OPACITY = 0.5;

    private final GlContext gl;
    private final RimLook look = new RimLook();
    /** Draws a membrane with the vertices of the opening, for every distance of the eye. */
    private final GlProgram<PortalUniforms> program;

    private final OpeningMesh openings;
    private final Blend over;

    private UnfilledPass(LoadContext context) {
        gl = context.gl();
        MeteredExposure.readInViews(context);
        Map<String, String> defines =
                Defines.of(context).with("OPACITY", OPACITY).values();
        program = GlProgram.of(
                gl, FOLDER + "membrane-in-opening.vert", FOLDER + "membrane.frag", defines, PortalUniforms.class);
        openings = context.get(OpeningMesh.RESOURCE);
        over = MeteredExposure.over(context);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return Required.ofOpenings(request, "openings that nothing fills", UnfilledPass::new);
    }

    @Override
    public void draw(FrameContext frame) {
        List<ViewNode> children = frame.node().children();
        for (int i = 0; i < children.size(); i++) {
            if (frame.nested().filling(children.get(i)) == Filling.SKY) {
                cover(frame, children.get(i));
            }
        }
    }

    private void cover(FrameContext frame, ViewNode child) {
        Opening opening = child.opening();
        if (opening.portal() == Opening.NO_PORTAL) {
            look.of(opening, frame.frameState().seconds(), frame.view());
        } else {
            look.of(frame.frameState(), opening.portal(), frame.view());
        }
        frame.surface().bind();
        gl.state().depthOf(OpeningMesh.depthOf(child));
        gl.state().set(Depth.EQUAL, over, Cull.NONE);
        program.use();
        look.putInto(program.uniforms());
        openings.draw(child);
        gl.state().depthOf(DepthOf.SURFACE);
    }
}
