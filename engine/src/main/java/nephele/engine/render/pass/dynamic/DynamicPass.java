package nephele.engine.render.pass.dynamic;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.DynamicMeshes.RunUniforms;
import nephele.engine.render.resource.EyeUniforms;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.dynamic.DynamicGroup;
import nephele.engine.scene.dynamic.HeldBodyVisibility;
import nephele.engine.scene.dynamic.VisibleInstances;

/**
 * Draws dynamic objects: one call for each run of visible objects of one group, with one program for each group. In the
 * player's own first-person view, the held body has a separate pass, because it is transparent and drawn over the rest of
 * the view. Bodies are convex, so one layer of front faces covers each pixel and no sorting is needed. The body's shadow
 * and its other images stay solid. Surfaces without texture receive procedural details, except in output PLAIN, which
 * shows values as stored.
 */
public final class DynamicPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("dynamic", Stage.IN_VIEWS, DynamicPass::requiredBy)
            .using(DynamicMeshes.RESOURCE, PictureArrays.COLOURS, PictureArrays.NORMALS, SurfaceLight.RESOURCE);

    public static final RenderFeature HELD = new RenderFeature(
                    "dynamic.held", Stage.IN_VIEWS_AFTER_OPAQUE, DynamicPass::heldRequiredBy)
            .using(DynamicMeshes.RESOURCE, PictureArrays.COLOURS, PictureArrays.NORMALS, SurfaceLight.RESOURCE);

    /** The opacity of the middle of a held face; a define of {@code held-look.glsl}. */
    public static final double HELD_FACE_OPACITY = 0.3;

    private static final String FOLDER = "/nephele/engine/render/pass/dynamic/";
    /** The view's plane and two of the object's own. */
    private static final int CLIP_DISTANCES = 3;
    /** Slope in pixels by which openings are drawn nearer than their surface. */
    private static final double SEAM_PIXELS = 1.5;

    private final GlContext gl;
    /** Whether only the held body is drawn, transparent except at edges: {@code held-look.glsl}. */
    private final boolean isOfHeld;

    private final TargetReads reads;
    private final DynamicMeshes meshes;
    private final PictureArrays colours;
    private final PictureArrays normals;
    private final SurfaceLight light;
    private final Quality quality;
    private final MaterialBlocks materials;
    private final boolean isCut;
    /** {@code null} for a group that is never drawn. */
    private final List<GlProgram<RunsUniforms>> programOfGroup = new ArrayList<>();

    private final VisibleInstances visible;
    private final HeldBodyVisibility held;

    private record RunsUniforms(
            EyeUniforms eye, @IfRead Scalar seamPerMetre, @IfRead Scalar clarity, RunUniforms run) {}

    private DynamicPass(LoadContext context, boolean isOfHeld, TargetReads reads) {
        this.isOfHeld = isOfHeld;
        this.reads = reads;
        gl = context.gl();
        meshes = context.get(DynamicMeshes.RESOURCE);
        colours = context.get(PictureArrays.COLOURS);
        normals = context.get(PictureArrays.NORMALS);
        light = context.get(SurfaceLight.RESOURCE);
        quality = context.quality();
        materials = context.own(new MaterialBlocks(gl, meshes.dynamicObjects().materials()));
        isCut = ViewTree.mayGrow(context.scene().level());
        Map<Map<String, String>, GlProgram<RunsUniforms>> programs = new HashMap<>();
        for (DynamicGroup group : meshes.dynamicObjects().groups()) {
            // The character, the only group of several parts, cannot be held.
            boolean isDrawn = !isOfHeld || group.parts() == 1;
            programOfGroup.add(
                    isDrawn ? programs.computeIfAbsent(defines(context, group.kind()), this::program) : null);
        }
        visible = new VisibleInstances(meshes.dynamicObjects(), meshes.copies());
        held = new HeldBodyVisibility(meshes.copies());
    }

    private Map<String, String> defines(LoadContext context, SolidBatch.Kind kind) {
        boolean isBare = !kind.isTextured() && !kind.isNormalMapped();
        Defines lit = light.addBounced(light.addForDynamicObjects(Defines.of(context)));
        Defines defines =
                materials.addTo(lit, kind, quality).withIf(isBare && context.output() != Output.PLAIN, "DETAIL");
        return isOfHeld
                ? defines.with("SEE_THROUGH")
                        .with("FACE_OPACITY", HELD_FACE_OPACITY)
                        .values()
                : defines.values();
    }

    private GlProgram<RunsUniforms> program(Map<String, String> defines) {
        return GlProgram.of(gl, FOLDER + "dynamic.vert", FOLDER + "dynamic.frag", defines, RunsUniforms.class);
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (!request.hasBodies() && !request.mayShowCharacter()) {
            return List.of();
        }
        String because = request.hasBodies() ? "bodies: dynamic objects" : "player: a visible character";
        return required(because, false, request);
    }

    /** Requires the pass for held bodies in a level with bodies and a player. */
    private static List<Required> heldRequiredBy(FrameRequest request) {
        return request.mayShowCharacter() && request.hasBodies()
                ? required("player: a body that is held", true, request)
                : List.of();
    }

    private static List<Required> required(String because, boolean isOfHeld, FrameRequest request) {
        TargetReads reads = request.lightMaps().dynamicObjects();
        return List.of(new Required(because, context -> new DynamicPass(context, isOfHeld, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        if (!isOfHeld) {
            meshes.update(frame.frameState());
        }
        held.find(frame.view(), frame.frameState());
        findVisible(frame);
        if (visible.runs() == 0) {
            return;
        }
        frame.surface().bind();
        gl.state()
                .set(
                        isOfHeld ? Depth.LESS_OR_EQUAL : Depth.LESS_AND_WRITE,
                        isOfHeld ? Blend.OVER : Blend.REPLACE,
                        Cull.BACK,
                        isCut ? CLIP_DISTANCES : 0);
        light.bind(reads);
        meshes.bind();
        for (int run = 0; run < visible.runs(); run++) {
            drawRun(frame, run);
        }
    }

    private void findVisible(FrameContext frame) {
        if (isOfHeld) {
            visible.selectHeld(held);
        } else if (frame.limits() != null) {
            visible.find(frame.view(), frame.limits(), frame.surface().height(), held);
        } else {
            visible.find(frame.view(), frame.surface().height(), held);
        }
    }

    private void drawRun(FrameContext frame, int run) {
        int group = visible.group(run);
        SolidBatch.Kind kind = meshes.dynamicObjects().groups().get(group).kind();
        GlProgram<RunsUniforms> program = programOfGroup.get(group);
        program.use();
        RunsUniforms uniforms = program.uniforms();
        uniforms.eye.set(frame.view(), light.anchor());
        double pixel =
                2 * frame.view().projection().tanHalfHeight() / frame.surface().height();
        uniforms.seamPerMetre.set(SEAM_PIXELS * pixel);
        uniforms.clarity.set(frame.frameState().heldClarity());
        materials.bind(kind.materialBlock());
        if (kind.isTextured()) {
            colours.get(kind.colourArray()).bind(TextureUnit.COLOURS);
        }
        if (MaterialBlocks.readsNormalMap(kind, quality)) {
            normals.get(kind.normalArray()).bind(TextureUnit.NORMALS);
        }
        meshes.draw(visible, run, uniforms.run);
    }
}
