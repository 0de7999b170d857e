package nephele.engine.render.pass.portal;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameEnvironment;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.NestedViews;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.DrawState.Stencil;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.ViewNode;
import org.joml.Vector3dc;

/**
 * Draws the content of each opening of a view, and of the openings in it. The stencil of a pixel holds the number of
 * openings in front of it: an opening increments it where it is the nearest surface, the nested view is drawn where the
 * number matches, and the opening decrements it again and leaves its own depth for later draws.
 */
public final class PortalPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "portal",
                    Stage.IN_VIEWS,
                    request -> Required.ofOpenings(request, "openings to see through", PortalPass::new))
            .using(OpeningMesh.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/portal/";

    private final GlContext gl;
    private final GlProgram<?> nothing;
    private final GlProgram<Uniforms.Vector4> colour;
    private final GlProgram<?> picture;
    private final OpeningMesh openings;
    private final FrameEnvironment surroundings;
    /** The fog between the eye and tinted mirrors, times the part of light that they absorb; {@code null} without fog. */
    private final GlProgram<Uniforms.Vector3> fog;
    /** True if the sky covers every pixel, so that the clear colour is never visible. */
    private final boolean skyCovers;

    private final double skyAlpha;

    private PortalPass(LoadContext context) {
        gl = context.gl();
        skyAlpha = context.request().skyAlpha();
        nothing = nothing(context);
        colour = program(context, "colour.frag", uniforms -> uniforms.vector4("colour"));
        picture = program(context, "picture.frag", uniforms -> uniforms);
        openings = context.get(OpeningMesh.RESOURCE);
        surroundings = context.resources().environment();
        fog = hasMirrorFog(context)
                ? program(context, "mirror-fog.frag", uniforms -> uniforms.vector3("keptBack"))
                : null;
        Environment environment = context.scene().level().environment();
        boolean isFogBefore = FogTransmittance.of(environment).isPresent();
        skyCovers = isFogBefore
                ? !FogTransmittance.hidesSky(environment)
                : environment.sky() != null && !(environment.sky() instanceof Sky.Constant);
    }

    /** Returns a program that places openings at the depth at which all programs do, and writes only depth and stencil. */
    static GlProgram<Uniforms> nothing(LoadContext context) {
        return program(context, "nothing.frag", uniforms -> uniforms);
    }

    private static <U> GlProgram<U> program(LoadContext context, String fragment, Function<Uniforms, U> uniforms) {
        Map<String, String> defines = Defines.of(context).values();
        return GlProgram.of(context.gl(), FOLDER + "opening.vert", FOLDER + fragment, defines, uniforms);
    }

    @Override
    public void draw(FrameContext frame) {
        List<ViewNode> children = frame.node().children();
        for (int i = 0; i < children.size(); i++) {
            ViewNode child = children.get(i);
            switch (frame.nested().filling(child)) {
                case SKY, VIEW -> {
                    drawThrough(frame, child);
                    addFog(child);
                }
                case PICTURE -> {
                    frame.nested().picture(child).bind(TextureUnit.COLOURS);
                    cover(frame, child, picture);
                    // The previous picture contains the fog already.
                    if (!child.isTerminal()) {
                        addFog(child);
                    }
                }
                case MARK -> {
                    colour.uniforms().set(NestedViews.MARK, 1);
                    cover(frame, child, colour);
                }
            }
        }
    }

    private void cover(FrameContext frame, ViewNode child, GlProgram<?> program) {
        frame.surface().bind();
        gl.state().depthOf(OpeningMesh.depthOf(child));
        draw(child, program, Depth.EQUAL);
        gl.state().depthOf(DepthOf.SURFACE);
    }

    private void addFog(ViewNode child) {
        if (fog != null) {
            gl.state().depthOf(OpeningMesh.depthOf(child));
            drawFog(child);
            gl.state().depthOf(DepthOf.SURFACE);
        }
    }

    /** Returns false if no fog is in front of mirrors, or if the output has no linear light to add to. */
    private static boolean hasMirrorFog(LoadContext context) {
        return FogTransmittance.of(context.scene().level().environment()).isPresent()
                && context.output() != Output.DIRECT
                && !context.scene().mirrors().isEmpty();
    }

    /**
     * Adds the fog in front of a tinted mirror to its reflection. A surface's radiance is tinted together with all fog in
     * front of it; this adds what the tint removed from the fog on this side, in linear light.
     *
     * @param child a filled opening whose own depth is the nearest
     */
    private void drawFog(ViewNode child) {
        Vec3 kept = child.opening().tint();
        if (kept.x() == 1 && kept.y() == 1 && kept.z() == 1) {
            return;
        }
        Vector3dc before = child.parent().view().tint();
        fog.uniforms().set(before.x() * (1 - kept.x()), before.y() * (1 - kept.y()), before.z() * (1 - kept.z()));
        gl.state().set(Depth.EQUAL, Blend.ADD, Cull.NONE);
        fog.use();
        openings.draw(child);
    }

    private void drawThrough(FrameContext frame, ViewNode child) {
        DrawState state = gl.state();
        int depth = frame.nested().openingsCounted(frame.node());
        frame.surface().bind();
        state.depthOf(OpeningMesh.depthOf(child));
        state.stencil(Stencil.EQUAL_COUNT_UP, depth);
        draw(child, nothing, Depth.EQUAL_ONLY_STENCIL);
        state.depthOf(DepthOf.FARTHEST);
        state.stencil(Stencil.EQUAL, depth + 1);
        if (!skyCovers) {
            colour.uniforms().set(surroundings.clearColour(child.view()), skyAlpha);
        }
        draw(
                child,
                skyCovers ? nothing : colour,
                skyCovers ? Depth.ALWAYS_AND_WRITE_ONLY_DEPTH : Depth.ALWAYS_AND_WRITE);
        state.depthOf(DepthOf.SURFACE);
        if (child.isTerminal()) {
            frame.nested().drawSky(frame, child);
        } else {
            frame.nested().draw(frame, child);
        }
        state.depthOf(OpeningMesh.depthOf(child));
        state.stencil(Stencil.EQUAL_COUNT_DOWN, depth + 1);
        draw(child, nothing, Depth.ALWAYS_AND_WRITE_ONLY_DEPTH);
        state.depthOf(DepthOf.SURFACE);
        state.stencil(depth == 0 ? Stencil.OFF : Stencil.EQUAL, depth);
    }

    private void draw(ViewNode child, GlProgram<?> program, Depth depth) {
        gl.state().set(depth, Blend.REPLACE, Cull.NONE);
        program.use();
        openings.draw(child);
    }
}
