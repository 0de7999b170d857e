package nephele.engine.render.pass.thing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.MaterialBlocks;
import nephele.engine.render.frame.PictureArrays;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.SolidMesh;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.TextureUnit;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.thing.ThingGroup;
import nephele.engine.scene.thing.VisibleThings;

/** Draws runs of instances: a program for each group of them, all of one look. */
final class ThingDraw {
    /** The view's plane and two of a thing's own. */
    private static final int CLIP_DISTANCES = 3;

    /** Openings are drawn a pixel's slope nearer than they are. */
    private static final double SEAM_PIXELS = 1.5;

    private final GlContext gl;
    private final ThingLook look;
    private final TargetReads reads;
    private final ThingMeshes meshes;
    private final PictureArrays colours;
    private final PictureArrays normals;
    private final SurfaceLight light;
    private final boolean cuts;
    private final MaterialBlocks materials;
    private final Map<ThingVariant, GlProgram<ThingUniforms>> programs = new HashMap<>();
    private final List<GlProgram<ThingUniforms>> programOfGroup = new ArrayList<>();
    private final float[] eye = new float[6];
    private float seamPerMetre;
    private float clarity;

    ThingDraw(LoadContext context, ThingLook look, TargetReads reads) {
        this.look = look;
        this.reads = reads;
        gl = context.gl();
        SharedResources shared = context.shared();
        meshes = shared.things();
        colours = shared.colourPictures();
        normals = shared.normalPictures();
        light = shared.surfaceLight();
        cuts = ViewTree.mayGrow(context.scene().level());
        materials = context.own(new MaterialBlocks(gl, meshes.things().materials()));
        meshes.things().groups().forEach(group -> programOfGroup.add(programFor(group, context)));
    }

    /** {@code null} for what is never drawn so: nobody holds a figure, the only thing of several parts. */
    private GlProgram<ThingUniforms> programFor(ThingGroup group, LoadContext context) {
        if (look == ThingLook.SEE_THROUGH && group.parts() > 1) {
            return null;
        }
        ThingVariant variant = ThingVariant.of(group.kind(), context.output(), look);
        return programs.computeIfAbsent(variant, wanted -> wanted.program(context, materials.materialsPerBlock()));
    }

    void draw(FrameContext frame, VisibleThings visible) {
        frame.surface().bind();
        gl.state().set(depth(), blend(), Cull.BACK, cuts ? CLIP_DISTANCES : 0);
        light.bind(reads);
        meshes.bind();
        double pixel =
                2 * frame.view().projection().tanHalfHeight() / frame.surface().height();
        seamPerMetre = (float) (SEAM_PIXELS * pixel);
        clarity = (float) frame.moment().heldClarity();
        SolidMesh.eyeInCell(frame.view(), light.anchor(), eye);
        for (int run = 0; run < visible.runs(); run++) {
            drawRun(visible, run);
        }
    }

    private Depth depth() {
        return look == ThingLook.SOLID ? Depth.LESS_AND_WRITE : Depth.LESS_OR_EQUAL;
    }

    private Blend blend() {
        return look == ThingLook.SOLID ? Blend.REPLACE : Blend.OVER;
    }

    private void drawRun(VisibleThings visible, int run) {
        int group = visible.group(run);
        SolidBatch.Kind kind = meshes.things().groups().get(group).kind();
        GlProgram<ThingUniforms> program = programOfGroup.get(group);
        program.use();
        program.uniforms().view(eye, seamPerMetre, clarity);
        materials.bind(kind.materialBlock());
        if (kind.isTextured()) {
            colours.get(kind.colourArray()).bind(TextureUnit.COLOURS);
        }
        if (kind.isNormalMapped()) {
            normals.get(kind.normalArray()).bind(TextureUnit.NORMALS);
        }
        meshes.draw(visible, run, program.uniforms().run());
    }
}
