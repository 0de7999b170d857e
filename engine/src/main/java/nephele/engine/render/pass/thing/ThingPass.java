package nephele.engine.render.pass.thing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.MaterialBlocks;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.PictureArrays;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.SolidMesh;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.ViewTree;
import nephele.engine.scene.thing.VisibleThings;

/** What moves: one call for each run of things that look alike and are seen. */
public final class ThingPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("thing", ThingPass::requiredBy);

    /** The view's plane and two of a thing's own. */
    private static final int CLIP_DISTANCES = 3;

    /** Openings are drawn a pixel's slope nearer than they are. */
    private static final double SEAM_PIXELS = 1.5;

    private final GlContext gl;
    private final Set<Target> reads;
    private final Map<ThingVariant, GlProgram<ThingUniforms>> programs = new HashMap<>();
    private final List<GlProgram<ThingUniforms>> programOfGroup = new ArrayList<>();
    private final float[] eye = new float[6];
    private ThingMeshes meshes;
    private VisibleThings visible;
    private MaterialBlocks materials;
    private PictureArrays colours;
    private PictureArrays normals;
    private SharedResources shared;
    private SurfaceLight light;
    private boolean cuts;
    private float seamPerMetre;

    private ThingPass(GlContext gl, Set<Target> reads) {
        this.gl = gl;
        this.reads = reads;
    }

    private static List<Required> requiredBy(Level level) {
        return level.bodies().isEmpty() ? List.of() : List.of(required(level, "bodies: things that move"));
    }

    /** What whoever plays asks for, in a level that asks for nothing itself. */
    public static Required forFigure(Level level) {
        return required(level, "player: a figure to be seen");
    }

    private static Required required(Level level, String because) {
        Set<Target> reads = SurfaceLight.targetsRead(level);
        return new Required(because, gl -> new ThingPass(gl, reads));
    }

    @Override
    public Set<Target> reads() {
        return reads;
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.SURFACE);
    }

    @Override
    public void load(LoadContext context) {
        shared = context.shared();
        meshes = shared.things(context);
        visible = new VisibleThings(meshes.things(), meshes.copies());
        colours = shared.colourPictures(context);
        normals = shared.normalPictures(context);
        light = shared.surfaceLight(context);
        cuts = ViewTree.mayGrow(context.scene().level());
        materials = new MaterialBlocks(gl, meshes.things().materials());
        for (var group : meshes.things().groups()) {
            ThingVariant variant = ThingVariant.of(group.kind(), context.output());
            programOfGroup.add(programs.computeIfAbsent(
                    variant, wanted -> wanted.program(context, materials.materialsPerBlock())));
        }
    }

    @Override
    public void draw(FrameContext frame) {
        meshes.update(frame.moment());
        see(frame);
        if (visible.runs() == 0) {
            return;
        }
        frame.surface().bind();
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.BACK, cuts ? CLIP_DISTANCES : 0);
        light.bindForThings(shared);
        meshes.bind();
        double pixel =
                2 * frame.view().projection().tanHalfHeight() / frame.surface().height();
        seamPerMetre = (float) (SEAM_PIXELS * pixel);
        SolidMesh.eyeInCell(frame.view(), light.anchor(), eye);
        for (int run = 0; run < visible.runs(); run++) {
            drawRun(run);
        }
    }

    private void see(FrameContext frame) {
        if (frame.limits() != null) {
            visible.find(frame.view(), frame.limits(), frame.surface().height());
        } else {
            visible.find(frame.view(), frame.surface().height());
        }
    }

    private void drawRun(int run) {
        int group = visible.group(run);
        SolidBatch.Kind kind = meshes.things().groups().get(group).kind();
        GlProgram<ThingUniforms> program = programOfGroup.get(group);
        program.use();
        program.uniforms().view(eye, seamPerMetre);
        materials.bind(kind.materialBlock());
        if (kind.isTextured()) {
            colours.get(kind.colourArray()).bind(ThingVariant.COLOUR_UNIT);
        }
        if (kind.isNormalMapped()) {
            normals.get(kind.normalArray()).bind(ThingVariant.NORMAL_UNIT);
        }
        meshes.draw(visible, run, program.uniforms().run());
    }

    @Override
    public void close() {
        programs.values().forEach(GlProgram::close);
        if (materials != null) {
            materials.close();
        }
    }
}
