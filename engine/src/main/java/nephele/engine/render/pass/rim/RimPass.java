package nephele.engine.render.pass.rim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.portal.Aperture;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
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
import nephele.engine.scene.FrameState;

/**
 * Draws rims around portals, in every view and before the openings are filled, so that a ring in front of a
 * neighbouring opening stays visible, while its glow, which writes no depth, never covers one. A portal without a
 * partner receives a membrane over its wall. Only what lies flat on the wall is moved in front of it: that step grows
 * with the slope of a face, and would show the sides of a ring through the floor that it stands on.
 */
public final class RimPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "portal.rim", Stage.IN_VIEWS, Role.DECORATION, RimPass::requiredBy)
            .using(MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/rim/";
    private static final double OPACITY_OVER_WALL = 0.93;

    private final GlContext gl;
    /** One for each kind of aperture, created when the first portal of its kind is drawn. */
    private final List<RimShape> shapes = new ArrayList<>();

    private final LoadContext context;
    private final GlProgram<PortalUniforms> ring;
    private final GlProgram<PortalUniforms> glow;
    private final GlProgram<PortalUniforms> membrane;
    private final RimLook look = new RimLook();
    private final Blend over;

    private RimPass(LoadContext context) {
        gl = context.gl();
        this.context = context;
        MeteredExposure.readInViews(context);
        ring = program(context, "ring.frag", Defines.of(context));
        glow = program(context, "glow.frag", Defines.of(context));
        membrane = program(context, "membrane.frag", Defines.of(context).with("OPACITY", OPACITY_OVER_WALL));
        over = MeteredExposure.over(context);
    }

    private static GlProgram<PortalUniforms> program(LoadContext context, String fragment, Defines names) {
        Map<String, String> defines = names.values();
        return GlProgram.of(context.gl(), FOLDER + "rim.vert", FOLDER + fragment, defines, PortalUniforms.class);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return Required.ofPortals(request, "rims of openings", RimPass::new);
    }

    @Override
    public void draw(FrameContext frame) {
        FrameState frameState = frame.frameState();
        frame.surface().bind();
        for (int i = 0; i < frameState.portals().size(); i++) {
            look.of(frameState, i, frame.view());
            if (look.isIn(frame.surface().height())) {
                drawRim(frame);
            }
        }
        for (int i = 0; i < frameState.closing().size(); i++) {
            look.of(frameState.closing().get(i), frameState, frame.view());
            if (look.isIn(frame.surface().height())) {
                drawRim(frame);
            }
        }
        for (int i = 0; i < frameState.previews().size(); i++) {
            look.of(frameState.previews().get(i), frameState, frame.view());
            if (look.isIn(frame.surface().height())) {
                drawPreview(frame);
            }
        }
    }

    private void drawRim(FrameContext frame) {
        RimShape shape = shape(look.portal.aperture());
        look.cells = shape.cells();
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE, frame.clipDistances());
        use(ring);
        shape.drawRing();
        gl.state().depthOf(DepthOf.OPENING);
        gl.state().set(Depth.LESS_OR_EQUAL, over, Cull.NONE, frame.clipDistances());
        use(glow);
        shape.drawGlow();
        if (!look.isOpen) {
            use(membrane);
            shape.drawArea();
        }
        gl.state().depthOf(DepthOf.SURFACE);
    }

    private RimShape shape(Aperture aperture) {
        for (int i = 0; i < shapes.size(); i++) {
            if (shapes.get(i).isOf(aperture)) {
                return shapes.get(i);
            }
        }
        shapes.add(context.own(new RimShape(gl, aperture)));
        return shapes.get(shapes.size() - 1);
    }

    private void drawPreview(FrameContext frame) {
        RimShape shape = shape(look.portal.aperture());
        look.cells = shape.cells();
        gl.state().set(Depth.LESS_OR_EQUAL, over, Cull.NONE, frame.clipDistances());
        use(ring);
        shape.drawRing();
    }

    private void use(GlProgram<PortalUniforms> program) {
        program.use();
        look.putInto(program.uniforms());
    }
}
