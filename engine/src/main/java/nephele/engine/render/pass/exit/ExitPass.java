package nephele.engine.render.pass.exit;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Exit;
import nephele.engine.level.appearance.ExitCurtain;
import nephele.engine.math.Aabb;
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
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/**
 * Adds the light of exits' curtains to each view, as far as surfaces do not hide it. Radiance is added in linear light:
 * by blending into a linear target, or by decoding the drawn pixel and encoding the sum for output DIRECT. As a second
 * pass it draws the veil between the strands of light, without which a curtain could not be seen before a bright wall:
 * see the proof {@code standing-out}.
 */
public final class ExitPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "exit", Stage.IN_VIEWS_AFTER_OPAQUE, request -> requiredBy(request, false))
            .using(MeteredExposure.RESOURCE);

    public static final RenderFeature VEIL = new RenderFeature(
                    "exit.veil", Stage.IN_VIEWS_AFTER_OPAQUE, Role.DECORATION, request -> requiredBy(request, true))
            .using(MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/exit/";

    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3);
    /** Sides of the prism in which a curtain is drawn. */
    private static final int SIDES = 24;

    private static final int PRISM_INDICES = 6 * SIDES + 2 * 3 * (SIDES - 2);

    private final GlContext gl;
    private final Map<Target, Texture> targets;
    private final TargetReads reads;
    private final Blend blend;
    private final List<Exit> exits;
    private final List<Aabb> bounds;
    private final GpuMesh prism;
    private final GlProgram<Places> program;

    private record Places(
            Uniforms.Whole drawnExit,
            Uniforms.Scalar seconds,
            List<Uniforms.Vector4> feetAndRadius,
            List<Uniforms.Scalar> heightMetres) {}

    private ExitPass(LoadContext context, boolean isVeil) {
        gl = context.gl();
        targets = context.targets();
        boolean decodes = !isVeil && context.output() == Output.DIRECT;
        reads = decodes ? TargetReads.of(Target.VIEW_DEPTH, Target.VIEW_COLOUR) : TargetReads.of(Target.VIEW_DEPTH);
        blend = isVeil ? MeteredExposure.over(context) : decodes ? Blend.REPLACE : MeteredExposure.added(context);
        exits = context.scene().level().exits();
        bounds = exits.stream().map(ExitPass::bounds).toList();
        prism = context.own(prism(gl));
        MeteredExposure.readInViews(context);
        Map<String, String> defines = Defines.of(context)
                .with("SHELL_SHARE", ExitCurtain.SHELL_SHARE)
                .with("EXITS", exits.size())
                .withIf(isVeil, "VEILS")
                .values();
        program = GlProgram.of(gl, FOLDER + "exit.vert", FOLDER + "exit.frag", defines, Places.class);
    }

    private static List<Required> requiredBy(FrameRequest request, boolean isVeil) {
        String because = isVeil ? "exits: veils in their curtains" : "exits: curtains of light";
        return request.level().exits().isEmpty()
                ? List.of()
                : List.of(new Required(because, context -> new ExitPass(context, isVeil)));
    }

    private static Aabb bounds(Exit exit) {
        double r = exit.radiusMetres();
        return new Aabb(
                exit.feet().x() - r,
                exit.feet().y(),
                exit.feet().z() - r,
                exit.feet().x() + r,
                exit.feet().y() + exit.heightMetres(),
                exit.feet().z() + r);
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public boolean needsCopies(FrameContext frame) {
        return isVisible(frame);
    }

    private boolean isVisible(FrameContext frame) {
        for (int i = 0; i < bounds.size(); i++) {
            if (frame.frustum().mayIntersect(bounds.get(i))) {
                return true;
            }
        }
        return false;
    }

    @Override
    public void draw(FrameContext frame) {
        if (!isVisible(frame)) {
            return;
        }
        frame.surface().bind();
        gl.state().set(Depth.OFF, blend, Cull.BACK, frame.clipDistances());
        reads.bind(targets);
        program.use();
        program.uniforms().seconds().set((float) frame.frameState().seconds());
        for (int i = 0; i < exits.size(); i++) {
            place(i, frame.view());
        }
        for (int i = 0; i < exits.size(); i++) {
            program.uniforms().drawnExit().set(i);
            prism.draw(0, PRISM_INDICES);
        }
    }

    private void place(int exit, View view) {
        Exit placed = exits.get(exit);
        program.uniforms()
                .feetAndRadius()
                .get(exit)
                .set(
                        (float) (placed.feet().x() - view.eyeX()),
                        (float) (placed.feet().y() - view.eyeY()),
                        (float) (placed.feet().z() - view.eyeZ()),
                        (float) placed.radiusMetres());
        program.uniforms().heightMetres().get(exit).set((float) placed.heightMetres());
    }

    /** Returns a closed upright prism around the unit cylinder, y from 0 to 1; its triangles face inwards. */
    private static GpuMesh prism(GlContext gl) {
        ByteBuffer bytes = MemoryUtil.memAlloc(2 * SIDES * FORMAT.strideBytes());
        IntBuffer indices = MemoryUtil.memAllocInt(PRISM_INDICES);
        try {
            corners(bytes);
            triangles(indices);
            return new GpuMesh(gl, "exit", FORMAT, bytes.flip(), indices.flip());
        } finally {
            MemoryUtil.memFree(bytes);
            MemoryUtil.memFree(indices);
        }
    }

    /** Writes corner 2 i at the base and 2 i + 1 above it; the sides touch the unit circle. */
    private static void corners(ByteBuffer bytes) {
        double radius = 1 / Math.cos(Math.PI / SIDES);
        for (int i = 0; i < SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            float x = (float) (radius * Math.cos(angle));
            float z = (float) (radius * Math.sin(angle));
            bytes.putFloat(x).putFloat(0).putFloat(z);
            bytes.putFloat(x).putFloat(1).putFloat(z);
        }
    }

    private static void triangles(IntBuffer indices) {
        for (int i = 0; i < SIDES; i++) {
            int here = 2 * i;
            int next = 2 * ((i + 1) % SIDES);
            indices.put(here).put(next).put(here + 1);
            indices.put(next).put(next + 1).put(here + 1);
        }
        for (int i = 2; i < SIDES; i++) {
            indices.put(0).put(2 * i).put(2 * i - 2);
            indices.put(1).put(2 * i - 1).put(2 * i + 1);
        }
    }
}
