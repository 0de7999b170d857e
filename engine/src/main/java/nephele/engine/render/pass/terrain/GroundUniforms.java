package nephele.engine.render.pass.terrain;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.terrain.TerrainLayers;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.DetailView;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.frame.Quality.TerrainDetail;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.TerrainUniforms;

/**
 * The uniforms of a terrain's program.
 *
 * @param detailView absent if all triangles are drawn
 * @param detailAlong the same
 * @param halfSteps the same
 * @param cell absent if no picture or light needs it
 * @param bakedPerMetre absent unless layers are mixed into one picture
 * @param texelsPerMetre of the layer map; absent without one
 * @param heights empty for one layer, which is everywhere
 * @param slopes the same
 * @param originFromAnchor absent if no light needs positions
 * @param origins empty without pictures
 */
record GroundUniforms(
        TerrainUniforms place,
        Optional<Vector4> detailView,
        Optional<Vector3> detailAlong,
        Optional<Vector2> halfSteps,
        Optional<Vector2> cell,
        Optional<Vector3> originFromAnchor,
        Optional<Vector2> bakedPerMetre,
        Optional<Vector2> texelsPerMetre,
        List<Vector4> heights,
        List<Vector4> slopes,
        List<Vector3> origins) {
    /** Steps a pixel of the grid to which rasterisers round corners; OpenGL demands 16, all known ones have 256. */
    private static final float STEPS_PER_PIXEL = 256;

    static GroundUniforms of(Uniforms uniforms, int layers, SurfaceLight light, TerrainDetail detail) {
        List<Vector4> heights = new ArrayList<>();
        List<Vector4> slopes = new ArrayList<>();
        List<Vector3> origins = new ArrayList<>();
        for (int i = 0; i < layers; i++) {
            if (layers > 1) {
                heights.add(uniforms.vector4("layerHeights[" + i + "]"));
                slopes.add(uniforms.vector4("layerSlopes[" + i + "]"));
            }
            if (uniforms.reads("layerOrigins[" + i + "]")) {
                origins.add(uniforms.vector3("layerOrigins[" + i + "]"));
            }
        }
        boolean isDetailed = detail == TerrainDetail.LOD;
        return new GroundUniforms(
                TerrainUniforms.of(uniforms),
                isDetailed ? Optional.of(uniforms.vector4("detailView")) : Optional.empty(),
                isDetailed ? Optional.of(uniforms.vector3("detailAlong")) : Optional.empty(),
                isDetailed ? Optional.of(uniforms.vector2("halfSteps")) : Optional.empty(),
                vector2(uniforms, "cellMetres"),
                light.needsPositions() ? Optional.of(uniforms.vector3("originFromAnchor")) : Optional.empty(),
                vector2(uniforms, "bakedPerMetre"),
                vector2(uniforms, "texelsPerMetre"),
                heights,
                slopes,
                origins);
    }

    private static Optional<Vector2> vector2(Uniforms uniforms, String name) {
        return uniforms.reads(name) ? Optional.of(uniforms.vector2(name)) : Optional.empty();
    }

    void set(HeightField field, GroundLook look, Vec3 anchor) {
        cell.ifPresent(lengths -> lengths.set((float) field.cellX(), (float) field.cellZ()));
        Vec3 origin = field.origin().minus(anchor);
        originFromAnchor.ifPresent(at -> at.set((float) origin.x(), (float) origin.y(), (float) origin.z()));
        bakedPerMetre.ifPresent(perMetre -> perMetre.set(
                (float) (1 / (field.cellX() * field.cellColumns())), (float) (1 / (field.cellZ() * field.cellRows()))));
        double[] limits = look.limits();
        for (int i = 0; i < heights.size(); i++) {
            set(heights.get(i), limits, TerrainLayers.LIMITS * i);
            set(slopes.get(i), limits, TerrainLayers.LIMITS * i + 4);
        }
        for (int i = 0; i < origins.size(); i++) {
            Vec3 repeats = look.origins().get(i);
            origins.get(i).set((float) repeats.x(), (float) repeats.y(), (float) repeats.z());
        }
    }

    void setPaint(HeightField field, LayerMap map) {
        double columns = (map.columns() - 1) / (field.cellX() * field.cellColumns());
        double rows = (map.rows() - 1) / (field.cellZ() * field.cellRows());
        texelsPerMetre.ifPresent(perMetre -> perMetre.set((float) columns, (float) rows));
    }

    /**
     * Sets the view of a terrain of few triangles.
     *
     * @param width of its picture, pixels; {@code height} likewise
     */
    void setDetail(DetailView view, int width, int height) {
        halfSteps.ifPresent(half -> half.set(STEPS_PER_PIXEL * width / 2, STEPS_PER_PIXEL * height / 2));
        Vec3 forward = view.forward();
        detailView.ifPresent(
                at -> at.set((float) forward.x(), (float) forward.y(), (float) forward.z(), (float) view.leastShare()));
        Vec3 along = view.along();
        detailAlong.ifPresent(at -> at.set((float) along.x(), (float) along.y(), (float) along.z()));
    }

    private static void set(Vector4 uniform, double[] values, int at) {
        uniform.set((float) values[at], (float) values[at + 1], (float) values[at + 2], (float) values[at + 3]);
    }
}
