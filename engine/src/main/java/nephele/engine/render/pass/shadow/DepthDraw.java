package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.Uniforms.Matrix4;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.render.resource.TerrainUniforms;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.VisibleSet;
import org.joml.Matrix4d;

/** Draws the depth of all solids, models and terrains under a projection; both sides of every face, to close cracks. */
final class DepthDraw {
    private static final String FOLDER = "/nephele/engine/render/pass/shadow/";

    private record DepthUniforms(Matrix4 clipFromCell, Scalar depthPerMetre) {}

    private record TerrainDepthUniforms(TerrainUniforms place, Matrix4 clipFromOrigin, Scalar depthPerMetre) {}

    private final LoadContext context;
    private final GlProgram<DepthUniforms> program;
    private final VisibleSet visible;
    private final List<TerrainMesh> terrains;
    /** {@code null} without terrains. */
    private final GlProgram<TerrainDepthUniforms> terrainProgram;

    DepthDraw(LoadContext context) {
        this.context = context;
        program =
                GlProgram.of(context.gl(), FOLDER + "depth.vert", FOLDER + "depth.frag", Map.of(), DepthUniforms.class);
        visible = new VisibleSet(context.scene().solids());
        terrains = context.get(TerrainMesh.RESOURCE);
        terrainProgram = terrains.isEmpty()
                ? null
                : GlProgram.of(
                        context.gl(),
                        FOLDER + "terrain-depth.vert",
                        FOLDER + "terrain-depth.frag",
                        Map.of(),
                        TerrainDepthUniforms.class);
    }

    /** Returns the layers of one kind that all renderers of an opened level share. */
    static DepthLayers layers(LoadContext context, String name) {
        record OfLevel(Identity level, String name, Quality quality) {}
        return context.share(
                DepthLayers.class,
                new OfLevel(context.openedLevel(), name, context.quality()),
                () -> new DepthLayers(context.gl(), name));
    }

    /**
     * Draws a sun's picture into the bound target.
     *
     * @param clipFromAnchor clip space from metres relative to {@code anchor}
     */
    void drawAll(Matrix4d clipFromAnchor, Vec3 anchor) {
        visible.selectAll();
        drawSolids(clipFromAnchor, anchor, 0);
        drawTerrains(Frustum.everything(), clipFromAnchor, anchor, 0);
    }

    /**
     * Draws a part of a sun's picture again, and leaves the scissor at it.
     *
     * @param within what can be seen in the part
     */
    void drawPart(RenderTarget target, Texture.Region part, Frustum within, Matrix4d clipFromAnchor, Vec3 anchor) {
        visible.find(within);
        context.gl().state().scissor(part.x(), part.y(), part.width(), part.height());
        target.clearDepthWithinScissor();
        drawSolids(clipFromAnchor, anchor, 0);
        drawTerrains(within, clipFromAnchor, anchor, 0);
    }

    /**
     * Draws a punctual light's picture.
     *
     * @param depthPerMetre 1 / the light's range
     */
    void drawInFrustum(RenderTarget target, Matrix4d clipFromAnchor, Vec3 anchor, double depthPerMetre) {
        Frustum lit = Frustum.of(clipFromAnchor, anchor);
        visible.find(lit);
        target.clearDepth();
        drawSolids(clipFromAnchor, anchor, depthPerMetre);
        drawTerrains(lit, clipFromAnchor, anchor, depthPerMetre);
    }

    private void drawSolids(Matrix4d clipFromAnchor, Vec3 anchor, double depthPerMetre) {
        context.gl().state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.NONE);
        program.use();
        program.uniforms().depthPerMetre().set((float) depthPerMetre);
        SolidMesh mesh = context.get(SolidMesh.RESOURCE);
        for (int i = 0; i < mesh.batches().size(); i++) {
            SolidBatch batch = mesh.batches().get(i);
            Vec3 cell = batch.cellOrigin();
            Matrix4d clipFromCell = clipFromAnchor.translate(
                    cell.x() - anchor.x(), cell.y() - anchor.y(), cell.z() - anchor.z(), new Matrix4d());
            program.uniforms().clipFromCell().set(clipFromCell.get(new float[16]));
            if (visible.size(i) > 0) {
                mesh.draw(i, visible);
            }
        }
    }

    /** Draws the parts of terrains in a frustum, in the state of the solids. */
    private void drawTerrains(Frustum frustum, Matrix4d clipFromAnchor, Vec3 anchor, double depthPerMetre) {
        for (TerrainMesh mesh : terrains) {
            HeightField field = mesh.field();
            Vec3 origin = field.origin();
            terrainProgram.use();
            TerrainDepthUniforms uniforms = terrainProgram.uniforms();
            uniforms.depthPerMetre().set((float) depthPerMetre);
            Matrix4d clipFromOrigin = clipFromAnchor.translate(
                    origin.x() - anchor.x(), origin.y() - anchor.y(), origin.z() - anchor.z(), new Matrix4d());
            uniforms.clipFromOrigin().set(clipFromOrigin.get(new float[16]));
            uniforms.place().set(field, origin.x(), origin.y(), origin.z());
            mesh.bind();
            mesh.draw(frustum, uniforms.place());
        }
    }
}
