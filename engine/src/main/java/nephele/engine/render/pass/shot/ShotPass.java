package nephele.engine.render.pass.shot;

import java.util.List;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Vec3;
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
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;
import org.joml.Vector3d;

/**
 * Draws the light of the last shots in every view, over its surfaces and hidden by them, each effect a rectangle. Between
 * shots it draws nothing.
 */
public final class ShotPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "shot", Stage.IN_VIEWS_AFTER_OPAQUE, Role.DECORATION, ShotPass::requiredBy)
            .using(MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/shot/";

    private static final float BOLT_METRES = 0.035f;
    /** Least half width of a bolt, pixels. */
    private static final double LEAST_PIXELS = 1.5;

    private static final double SHIMMER_METRES = 0.75;
    /** Distance of a shimmer from its surface. */
    private static final double ABOVE_METRES = 0.012;

    /** Brightness where flashes are softened. */
    private static final float SOFTENED = 0.45f;

    private record Places(
            Uniforms.Vector3 origin,
            Uniforms.Vector3 along,
            Uniforms.Vector3 across,
            Uniforms.Vector2 widths,
            Uniforms.Vector3 tint,
            Uniforms.Vector3 ageAndKind) {}

    private final GlContext gl;
    private final Blend over;
    private final GlProgram<Places> program;
    private final GpuMesh quad;
    private final Vector3d origin = new Vector3d();
    private final Vector3d along = new Vector3d();
    private final Vector3d across = new Vector3d();

    private ShotPass(LoadContext context) {
        gl = context.gl();
        over = MeteredExposure.over(context);
        MeteredExposure.readInViews(context);
        var defines = Defines.of(context).values();
        program = GlProgram.of(gl, FOLDER + "shot.vert", FOLDER + "shot.frag", defines, Places.class);
        quad = context.own(GpuMesh.squares(gl, "light of shots", 1));
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.mayShowCharacter() && request.level().portalGun() != null
                ? List.of(new Required("portalGun: the light of its shots", ShotPass::new))
                : List.of();
    }

    @Override
    public void draw(FrameContext frame) {
        List<FrameState.ShotEffect> effects = frame.frameState().shotEffects();
        if (effects.isEmpty()) {
            return;
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, over, Cull.NONE, frame.clipDistances());
        program.use();
        for (int i = 0; i < effects.size(); i++) {
            draw(frame, effects.get(i));
        }
    }

    private void draw(FrameContext frame, FrameState.ShotEffect effect) {
        View view = frame.view();
        boolean isBolt = effect.kind() == FrameState.ShotEffect.Kind.BOLT;
        boolean isSoftened = frame.frameState().flashStyle() == FlashStyle.SOFTENED;
        Places places = program.uniforms();
        fromEye(view, effect.from(), origin);
        fromEye(view, effect.to(), along).sub(origin);
        if (isBolt) {
            // The same direction at every point of its path.
            along.cross(origin, across);
            across.div(Math.max(across.length(), 1e-12));
        } else {
            origin.fma(ABOVE_METRES, along);
            Vector3d normal = new Vector3d(along);
            normal.cross(Math.abs(normal.y) < 0.9 ? new Vector3d(0, 1, 0) : new Vector3d(1, 0, 0), along);
            along.normalize(SHIMMER_METRES);
            normal.cross(along, across);
        }
        double pixel = 2 * view.projection().tanHalfHeight() / frame.surface().height();
        set(places.origin, origin);
        set(places.along, along);
        set(places.across, across);
        places.widths.set(isBolt ? BOLT_METRES : -1, (float) (LEAST_PIXELS * pixel));
        Vec3 tint = frame.frameState().shotPalette().rim(effect.colour());
        places.tint.set((float) tint.x(), (float) tint.y(), (float) tint.z());
        places.ageAndKind.set((float) effect.age(), isBolt ? 0 : 1, isSoftened ? SOFTENED : 1);
        quad.draw(0, GpuMesh.SQUARE_INDICES);
    }

    private static Vector3d fromEye(View view, Vec3 place, Vector3d out) {
        return out.set(place.x() - view.eyeX(), place.y() - view.eyeY(), place.z() - view.eyeZ());
    }

    private static void set(Uniforms.Vector3 uniform, Vector3d v) {
        uniform.set((float) v.x, (float) v.y, (float) v.z);
    }
}
