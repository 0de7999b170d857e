package nephele.engine.render.pass.impostor;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import nephele.engine.level.ModelPlacement;
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
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.KindMesh;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.PlantedScene;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.Projection;
import nephele.engine.scene.impostor.ImpostorAtlas;

/**
 * Draws models with impostors in each view, chosen by their size in its pixels: meshes where they are large, impostors
 * where they are small, and between the two each in its own pixels of a fixed pattern.
 */
public final class ImpostorPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("impostor", Stage.IN_VIEWS, ImpostorPass::requiredBy)
            .using(SurfaceLight.RESOURCE, PictureArrays.COLOURS, MeteredExposure.RESOURCE);

    private final GlContext gl;
    private final TargetReads reads;
    private final SurfaceLight light;
    private final PlantedScene plants;
    private final PlantChoice choice;
    private final Blend impostorBlend;
    /** {@code null} if only meshes are drawn. */
    private final PlantProgram impostor;

    private final List<PlantProgram> programOfKind;
    private final List<Texture> pictureOfKind;

    private ImpostorPass(LoadContext context, TargetReads reads) {
        this.reads = reads;
        gl = context.gl();
        light = context.get(SurfaceLight.RESOURCE);
        double pixels = context.quality().impostorPixels();
        plants = PlantedScene.of(context);
        choice = context.own(new PlantChoice(gl, plants, pixels));
        impostorBlend = context.quality().samples() > 1 ? Blend.REPLACE_COVERED_SAMPLES : Blend.REPLACE;
        impostor = pixels == 0 ? null : PlantProgram.ofImpostors(context);
        PlantProgram bare = ofMeshes(context, false);
        PlantProgram textured = ofMeshes(context, true);
        programOfKind = plants.meshes().stream()
                .map(mesh -> isTextured(mesh) ? textured : bare)
                .toList();
        pictureOfKind = plants.meshes().stream()
                .map(mesh -> isTextured(mesh)
                        ? context.get(PictureArrays.COLOURS)
                                .get(mesh.surface().colour().array())
                        : null)
                .toList();
    }

    /** Returns {@code null} if no kind needs it. */
    private PlantProgram ofMeshes(LoadContext context, boolean areTextured) {
        return plants.meshes().stream().anyMatch(mesh -> isTextured(mesh) == areTextured)
                ? PlantProgram.ofMeshes(context, areTextured)
                : null;
    }

    private static boolean isTextured(KindMesh mesh) {
        return mesh.surface().colour().array() >= 0;
    }

    private static List<Required> requiredBy(FrameRequest request) {
        List<ModelPlacement> models = request.level().models();
        int[] found = IntStream.range(0, models.size())
                .filter(i -> models.get(i).impostor())
                .toArray();
        if (found.length == 0) {
            return List.of();
        }
        TargetReads reads = request.lightMaps().dynamicObjects();
        String because = "models[" + found[0] + "].impostor: pictures of it where it is small";
        return List.of(new Required(because, context -> new ImpostorPass(context, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        double pixelsPerRadian = pixelsPerRadian(frame);
        choice.find(frame.view(), frame.frustum(), pixelsPerRadian);
        frame.surface().bind();
        light.bind(reads);
        plants.bind();
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.BACK, frame.clipDistances());
        for (int kind = 0; kind < plants.meshes().size(); kind++) {
            if (choice.meshes(kind).count() > 0) {
                drawMeshes(frame, kind, pixelsPerRadian);
            }
        }
        if (choice.impostors().count() > 0) {
            gl.state().set(Depth.LESS_AND_WRITE, impostorBlend, Cull.NONE, frame.clipDistances());
            impostor.use(frame.view(), pixelsPerRadian);
            plants.bindAtlases();
            choice.impostors().draw();
        }
    }

    private void drawMeshes(FrameContext frame, int kind, double pixelsPerRadian) {
        KindMesh mesh = plants.meshes().get(kind);
        PlantProgram program = programOfKind.get(kind);
        program.use(frame.view(), pixelsPerRadian);
        program.material(mesh.surface(), ImpostorAtlas.lobe(mesh.surface().material()));
        if (pictureOfKind.get(kind) != null) {
            pictureOfKind.get(kind).bind(TextureUnit.COLOURS);
        }
        choice.meshes(kind).draw(mesh);
    }

    /** Returns the pixels that an angle of a radian has in the middle of the picture. */
    private static double pixelsPerRadian(FrameContext frame) {
        Projection projection = frame.view().projection();
        return frame.surface().height() / (2 * projection.tanHalfHeight());
    }
}
