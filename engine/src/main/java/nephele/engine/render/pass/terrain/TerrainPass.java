package nephele.engine.render.pass.terrain;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.level.placed.StaticShape;
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
import nephele.engine.render.resource.PictureArrays;
import nephele.engine.render.resource.SummedLight;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.TerrainMesh;

/** Draws terrains, with all their triangles or with as many as the view needs. */
public final class TerrainPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature("terrain", Stage.IN_VIEWS, TerrainPass::requiredBy)
            .using(
                    TerrainMesh.RESOURCE,
                    PictureArrays.COLOURS,
                    PictureArrays.NORMALS,
                    SurfaceLight.RESOURCE,
                    SummedLight.RESOURCE);

    private final GlContext gl;
    private final TargetReads reads;
    private final SurfaceLight light;
    private final List<GroundDrawing> grounds = new ArrayList<>();

    private TerrainPass(LoadContext context, TargetReads reads) {
        this.reads = reads;
        gl = context.gl();
        light = context.get(SurfaceLight.RESOURCE);
        List<StaticShape.HeightGrid> grids = context.scene().statics().ground();
        List<TerrainMesh> meshes = context.get(TerrainMesh.RESOURCE);
        for (int i = 0; i < grids.size(); i++) {
            grounds.add(new GroundDrawing(context, grids.get(i), meshes.get(i)));
        }
    }

    private static List<Required> requiredBy(FrameRequest request) {
        if (request.level().terrains().isEmpty()) {
            return List.of();
        }
        TargetReads reads = request.lightMaps().ground();
        return List.of(new Required("terrains: ground to see", context -> new TerrainPass(context, reads)));
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().bind();
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.BACK, frame.clipDistances());
        light.bind(reads);
        for (int i = 0; i < grounds.size(); i++) {
            grounds.get(i).draw(frame);
        }
    }
}
