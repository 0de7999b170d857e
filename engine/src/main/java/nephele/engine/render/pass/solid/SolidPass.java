package nephele.engine.render.pass.solid;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
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
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.resource.EyeUniforms;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.SummedLight;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.light.LightRequirements;

/** Draws solids and models: one multi-draw for each batch. */
public final class SolidPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("solid", Stage.IN_VIEWS, SolidPass::requiredBy)
            .using(
                    SolidMesh.RESOURCE,
                    PictureArrays.COLOURS,
                    PictureArrays.NORMALS,
                    SurfaceLight.RESOURCE,
                    SummedLight.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/solid/";

    private final GlContext gl;
    private final TargetReads reads;
    private final List<GlProgram<BatchUniforms>> programOfBatch = new ArrayList<>();
    private final List<Boolean> normalMapped = new ArrayList<>();
    private final MaterialBlocks materials;
    private final SolidMesh mesh;
    private final PictureArrays colours;
    private final PictureArrays normals;
    private final SurfaceLight light;
    /** {@code null} without baked light. */
    private final SummedLight baked;
    /** Writes only depth; {@code null} if light is constant over each face and costs little. */
    private final GlProgram<EyeUniforms> depthFirst;

    private record BatchUniforms(EyeUniforms eye, @IfRead Vector3 cellFromAnchor) {}

    private SolidPass(LoadContext context, TargetReads reads) {
        this.reads = reads;
        gl = context.gl();
        mesh = context.get(SolidMesh.RESOURCE);
        colours = context.get(PictureArrays.COLOURS);
        normals = context.get(PictureArrays.NORMALS);
        light = context.get(SurfaceLight.RESOURCE);
        baked = context.get(SummedLight.RESOURCE);
        depthFirst = light.variesOverFaces() ? depthProgram(context) : null;
        materials =
                context.own(new MaterialBlocks(gl, context.scene().materials().surfaces()));
        Map<Map<String, String>, GlProgram<BatchUniforms>> programs = new HashMap<>();
        for (SolidBatch batch : mesh.batches()) {
            normalMapped.add(MaterialBlocks.readsNormalMap(batch.kind(), context.quality()));
            programOfBatch.add(programs.computeIfAbsent(
                    defines(context, batch),
                    defines -> GlProgram.of(
                            gl, FOLDER + "solid.vert", FOLDER + "solid.frag", defines, BatchUniforms.class)));
        }
    }

    private Map<String, String> defines(LoadContext context, SolidBatch batch) {
        SolidBatch.Form form = batch.form();
        boolean isNormalMapped = MaterialBlocks.readsNormalMap(batch.kind(), context.quality());
        boolean isLitPerFace = !form.isModel() && batch.kind().lambert() && !isNormalMapped && !light.variesOverFaces();
        boolean anyEmits = context.scene().level().materials().stream()
                .anyMatch(material -> !material.emission().equals(Vec3.ZERO));
        Defines lit = form.isModel() ? light.addForModels(Defines.of(context)) : light.addTo(Defines.of(context));
        return materials
                .addTo(lit, batch.kind(), context.quality())
                .withIf(anyEmits, "EMISSION")
                .withIf(form.isModel(), "MODEL")
                .withIf(form == SolidBatch.Form.CURVED_MODEL, "CURVED_RECEIVER")
                .withIf(form == SolidBatch.Form.TURNED_SOLID && isNormalMapped, "TURNED_TEXTURE")
                .withIf(isLitPerFace, "FLAT_LIGHT")
                .values();
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Level level = request.level();
        if (!LightRequirements.hasMeshes(level)) {
            return List.of();
        }
        String what = LightRequirements.surfaces(level);
        TargetReads reads = request.lightMaps().solids();
        return List.of(new Required(what + ": surfaces to see", context -> new SolidPass(context, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().bind();
        if (depthFirst == null) {
            gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.BACK, frame.clipDistances());
        } else {
            drawDepth(frame);
            gl.state().set(Depth.LESS_OR_EQUAL, Blend.REPLACE, Cull.BACK, frame.clipDistances());
        }
        light.bind(reads);
        if (baked != null && baked.models() != null) {
            baked.models().bind(TextureUnit.MODEL_LIGHT);
        }
        for (int i = 0; i < programOfBatch.size(); i++) {
            if (frame.visible().size(i) > 0) {
                drawBatch(frame, i);
            }
        }
    }

    private static GlProgram<EyeUniforms> depthProgram(LoadContext context) {
        Map<String, String> defines = Defines.of(context).values();
        return GlProgram.of(context.gl(), FOLDER + "depth.vert", FOLDER + "depth.frag", defines, EyeUniforms.class);
    }

    /** Writes the depth of all solids, so that costly light is computed once a pixel and never for hidden surfaces. */
    private void drawDepth(FrameContext frame) {
        gl.state().set(Depth.LESS_AND_WRITE_ONLY_DEPTH, Blend.REPLACE, Cull.BACK, frame.clipDistances());
        depthFirst.use();
        for (int i = 0; i < mesh.batches().size(); i++) {
            depthFirst.uniforms().set(frame.view(), mesh.batches().get(i).cellOrigin());
            mesh.draw(i, frame.visible());
        }
    }

    private void drawBatch(FrameContext frame, int index) {
        SolidBatch batch = mesh.batches().get(index);
        GlProgram<BatchUniforms> program = programOfBatch.get(index);
        program.use();
        Vec3 cell = batch.cellOrigin();
        program.uniforms().eye().set(frame.view(), cell);
        Vec3 anchor = light.anchor();
        program.uniforms().cellFromAnchor().set(cell.x() - anchor.x(), cell.y() - anchor.y(), cell.z() - anchor.z());
        materials.bind(batch.kind().materialBlock());
        if (batch.kind().isTextured()) {
            colours.get(batch.kind().colourArray()).bind(TextureUnit.COLOURS);
        }
        if (normalMapped.get(index)) {
            normals.get(batch.kind().normalArray()).bind(TextureUnit.NORMALS);
        }
        mesh.draw(index, frame.visible());
    }
}
