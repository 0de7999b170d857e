package nephele.engine.render.pass.terrain;

import java.util.List;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.DetailView;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.TerrainUniforms;

/** The uniforms of a terrain's program. The program reads what the terrain, its layers and its light require. */
record GroundUniforms(
        TerrainUniforms place,
        @IfRead Vector4 detailView,
        @IfRead Vector3 detailAlong,
        @IfRead Vector2 halfSteps,
        @IfRead Vector2 cellMetres,
        @IfRead Vector3 originFromAnchor,
        @IfRead Vector2 bakedPerMetre,
        @IfRead Vector2 texelsPerMetre,
        @IfRead List<Vector4> layerHeights,
        @IfRead List<Vector4> layerSlopes,
        @IfRead List<Vector3> layerOrigins) {
    /** Steps a pixel of the grid to which rasterisers round corners; OpenGL demands 16, all known ones have 256. */
    private static final float STEPS_PER_PIXEL = 256;

    void set(HeightField field, GroundLook look, Vec3 anchor) {
        cellMetres.set(field.cellX(), field.cellZ());
        originFromAnchor.set(field.origin().minus(anchor));
        bakedPerMetre.set(1 / (field.cellX() * field.cellColumns()), 1 / (field.cellZ() * field.cellRows()));
        double[] limits = look.limits();
        for (int i = 0; i < layerHeights.size(); i++) {
            set(layerHeights.get(i), limits, TerrainLayers.LIMITS * i);
            set(layerSlopes.get(i), limits, TerrainLayers.LIMITS * i + 4);
        }
        for (int i = 0; i < layerOrigins.size(); i++) {
            layerOrigins.get(i).set(look.origins().get(i));
        }
    }

    void setPaint(HeightField field, LayerMap map) {
        double columns = (map.columns() - 1) / (field.cellX() * field.cellColumns());
        double rows = (map.rows() - 1) / (field.cellZ() * field.cellRows());
        texelsPerMetre.set(columns, rows);
    }

    /**
     * Sets the view of a terrain of few triangles.
     *
     * @param width of its picture, pixels; {@code height} likewise
     */
    void setDetail(DetailView view, int width, int height) {
        halfSteps.set(STEPS_PER_PIXEL * width / 2, STEPS_PER_PIXEL * height / 2);
        detailView.set(view.forward(), view.leastShare());
        detailAlong.set(view.along());
    }

    private static void set(Vector4 uniform, double[] values, int at) {
        uniform.set(values[at], values[at + 1], values[at + 2], values[at + 3]);
    }
}
