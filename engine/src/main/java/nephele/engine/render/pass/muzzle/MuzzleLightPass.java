package nephele.engine.render.pass.muzzle;

import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.DrawState.Stencil;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.scene.MuzzleLight;
import nephele.engine.scene.View;
import nephele.engine.scene.ViewNode;

/**
 * Adds the light of a shot to the surfaces of each view, but not to what is seen through their openings: the views behind
 * them have it already. It reads copies of the view; between shots it draws nothing and nothing is copied for it.
 */
public final class MuzzleLightPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "muzzle", Stage.IN_VIEWS_AFTER_OPAQUE, Role.DECORATION, MuzzleLightPass::requiredBy)
            .using(OpeningMesh.RESOURCE, MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/muzzle/";
    private static final TargetReads READS = TargetReads.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR);
    private static final Set<Target> DECLARED = READS.declared();

    private record Places(Uniforms.Vector4 muzzle, Uniforms.Vector4 intensity) {}

    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final Blend added;
    private final GlProgram<Places> light;
    private final GlProgram<Uniforms> nothing;
    private final FullScreenTriangle triangle;
    private final OpeningMesh openings;

    private MuzzleLightPass(LoadContext context) {
        gl = context.gl();
        targets = context.targets();
        added = MeteredExposure.added(context);
        openings = context.get(OpeningMesh.RESOURCE);
        triangle = context.own(new FullScreenTriangle(gl, "muzzle.frag"));
        MeteredExposure.readInViews(context);
        var defines = Defines.of(context).values();
        light = GlProgram.of(gl, FOLDER + "muzzle.vert", FOLDER + "muzzle.frag", defines, Places.class);
        nothing = GlProgram.of(gl, FOLDER + "opening.vert", FOLDER + "opening.frag", defines);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.mayShowCharacter() && request.level().portalGun() != null && request.output() != Output.PLAIN
                ? List.of(new Required("portalGun: the light of its shots on surfaces", MuzzleLightPass::new))
                : List.of();
    }

    @Override
    public Set<Target> reads() {
        return DECLARED;
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        MuzzleLight muzzle = frame.frameState().muzzleLight();
        return muzzle != null && frame.frustum().mayIntersect(muzzle.bounds());
    }

    @Override
    public void draw(FrameContext frame) {
        if (!needsCopies(frame)) {
            return;
        }
        frame.surface().bind();
        List<ViewNode> children = frame.node().children();
        int depth = frame.nested().openingsCounted(frame.node());
        DrawState state = gl.state();
        if (!children.isEmpty()) {
            state.stencil(Stencil.EQUAL_COUNT_UP, depth);
            drawOpenings(children);
            state.stencil(Stencil.EQUAL, depth);
        }
        state.set(Depth.OFF, added, Cull.NONE);
        READS.bind(targets);
        light.use();
        place(frame);
        triangle.draw();
        if (!children.isEmpty()) {
            state.stencil(Stencil.EQUAL_COUNT_DOWN, depth + 1);
            drawOpenings(children);
            state.stencil(depth == 0 ? Stencil.OFF : Stencil.EQUAL, depth);
        }
    }

    /** Counts the visible pixels of openings in the stencil. */
    private void drawOpenings(List<ViewNode> children) {
        gl.state().set(Depth.EQUAL_ONLY_STENCIL, Blend.REPLACE, Cull.NONE);
        nothing.use();
        for (int i = 0; i < children.size(); i++) {
            gl.state().depthOf(OpeningMesh.depthOf(children.get(i)));
            openings.draw(children.get(i));
        }
        gl.state().depthOf(DepthOf.SURFACE);
    }

    private void place(FrameContext frame) {
        MuzzleLight muzzle = frame.frameState().muzzleLight();
        View view = frame.view();
        Vec3 at = muzzle.place();
        Places places = light.uniforms();
        places.muzzle.set(
                (float) (at.x() - view.eyeX()), (float) (at.y() - view.eyeY()), (float) (at.z() - view.eyeZ()), (float)
                        MuzzleLight.SOURCE_SQUARE_METRES);
        Vec3 tint = frame.frameState().shotPalette().rim(muzzle.colour());
        double bright = muzzle.strength() * MuzzleLight.INTENSITY;
        places.intensity.set(
                (float) (bright * tint.x()), (float) (bright * tint.y()), (float) (bright * tint.z()), (float)
                        (1 / (MuzzleLight.RANGE_METRES * MuzzleLight.RANGE_METRES)));
    }
}
