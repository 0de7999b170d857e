package nephele.engine.render.pass.dynamic;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality.NormalMaps;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.dynamic.DynamicGroup;
import nephele.engine.scene.dynamic.VisibleInstances;

/** Draws runs of instances: one program for each group, all with the same blending. */
final class DynamicDraw {
    /** The view's plane and two of the object's own. */
    private static final int CLIP_DISTANCES = 3;

    /** Slope in pixels by which openings are drawn nearer than their surface. */
    private static final double SEAM_PIXELS = 1.5;

    private final GlContext gl;
    private final DynamicBlending look;
    private final TargetReads reads;
    private final DynamicMeshes meshes;
    private final PictureArrays colours;
    private final PictureArrays normals;
    private final SurfaceLight light;
    private final boolean normalMaps;
    private final boolean cuts;
    private final MaterialBlocks materials;
    private final Map<DynamicVariant, GlProgram<DynamicUniforms>> programs = new HashMap<>();
    private final List<GlProgram<DynamicUniforms>> programOfGroup = new ArrayList<>();
    private final float[] eye = new float[6];
    private float seamPerMetre;
    private float clarity;

    DynamicDraw(LoadContext context, DynamicBlending look, TargetReads reads) {
        this.look = look;
        this.reads = reads;
        gl = context.gl();
        meshes = context.get(DynamicMeshes.RESOURCE);
        colours = context.get(PictureArrays.COLOURS);
        normals = context.get(PictureArrays.NORMALS);
        light = context.get(SurfaceLight.RESOURCE);
        normalMaps = context.quality().normalMaps() == NormalMaps.ON;
        cuts = ViewTree.mayGrow(context.scene().level());
        materials = context.own(new MaterialBlocks(gl, meshes.dynamicObjects().materials()));
        meshes.dynamicObjects().groups().forEach(group -> programOfGroup.add(programFor(group, context)));
    }

    /**
     * Returns {@code null} for groups that are never drawn so: the character, the only group of several parts, cannot
     * be held.
     */
    private GlProgram<DynamicUniforms> programFor(DynamicGroup group, LoadContext context) {
        if (look == DynamicBlending.SEE_THROUGH && group.parts() > 1) {
            return null;
        }
        DynamicVariant variant = DynamicVariant.of(group.kind(), context, look);
        return programs.computeIfAbsent(variant, wanted -> wanted.program(context, materials.materialsPerBlock()));
    }

    void draw(FrameContext frame, VisibleInstances visible) {
        frame.surface().bind();
        gl.state().set(depth(), blend(), Cull.BACK, cuts ? CLIP_DISTANCES : 0);
        light.bind(reads);
        meshes.bind();
        double pixel =
                2 * frame.view().projection().tanHalfHeight() / frame.surface().height();
        seamPerMetre = (float) (SEAM_PIXELS * pixel);
        clarity = (float) frame.frameState().heldClarity();
        SolidMesh.eyeInCell(frame.view(), light.anchor(), eye);
        for (int run = 0; run < visible.runs(); run++) {
            drawRun(visible, run);
        }
    }

    private Depth depth() {
        return look == DynamicBlending.SOLID ? Depth.LESS_AND_WRITE : Depth.LESS_OR_EQUAL;
    }

    private Blend blend() {
        return look == DynamicBlending.SOLID ? Blend.REPLACE : Blend.OVER;
    }

    private void drawRun(VisibleInstances visible, int run) {
        int group = visible.group(run);
        SolidBatch.Kind kind = meshes.dynamicObjects().groups().get(group).kind();
        GlProgram<DynamicUniforms> program = programOfGroup.get(group);
        program.use();
        program.uniforms().view(eye, seamPerMetre, clarity);
        materials.bind(kind.materialBlock());
        if (kind.isTextured()) {
            colours.get(kind.colourArray()).bind(TextureUnit.COLOURS);
        }
        if (normalMaps && kind.isNormalMapped()) {
            normals.get(kind.normalArray()).bind(TextureUnit.NORMALS);
        }
        meshes.draw(visible, run, program.uniforms().run());
    }
}
