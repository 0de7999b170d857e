package nephele.engine.render.resource;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Material;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.NormalMaps;
import nephele.engine.render.frame.Quality.ReflectionModel;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.render.gl.shader.UniformBlock;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.SolidGeometry;

/** The parameters of the materials in uniform blocks, in the layout of {@code materials.glsl}. */
public final class MaterialBlocks implements GlObject {
    private static final int FLOATS_PER_MATERIAL = 16;

    private final List<UniformBuffer> blocks = new ArrayList<>();
    private final int materialsPerBlock;

    public MaterialBlocks(GlContext gl, List<Surface> surfaces) {
        // A power of two: the size is a constant in the shaders, and a few more materials should not need other
        // programs.
        int least = Integer.highestOneBit(2 * surfaces.size() - 1);
        materialsPerBlock = Math.min(least, SolidGeometry.MATERIALS_PER_BLOCK);
        for (int first = 0; first < surfaces.size(); first += materialsPerBlock) {
            float[] values = new float[FLOATS_PER_MATERIAL * materialsPerBlock];
            for (int i = 0; i < materialsPerBlock && first + i < surfaces.size(); i++) {
                put(values, FLOATS_PER_MATERIAL * i, surfaces.get(first + i));
            }
            UniformBuffer block = new UniformBuffer(gl, "materials", values.length);
            block.upload(values);
            blocks.add(block);
        }
    }

    private static void put(float[] values, int at, Surface surface) {
        Material m = surface.material();
        m.baseColour().put(values, at, m.roughness() == null ? 1 : m.roughness());
        m.emission().put(values, at + 4, m.metallic() == null ? 0 : m.metallic());
        values[at + 8] = surface.colour().layer();
        values[at + 9] = surface.normal().layer();
        values[at + 10] = (float) m.textureMetres();
    }

    /** Adds the defines of the shader code that reads these materials, for surfaces of one kind. */
    public Defines addTo(Defines defines, SolidBatch.Kind kind, Quality quality) {
        String diffuseOrNot = quality.brdf() == ReflectionModel.LAMBERT ? "ALL_DIFFUSE" : "METALLIC_ROUGHNESS";
        return defines.with("MATERIAL_COUNT", materialsPerBlock)
                .with(kind.lambert() ? "LAMBERT" : diffuseOrNot)
                .withIf(kind.isTextured(), "TEXTURED")
                .withIf(readsNormalMap(kind, quality), "NORMAL_MAP");
    }

    /** Returns true if surfaces of a kind are drawn with a normal map. */
    public static boolean readsNormalMap(SolidBatch.Kind kind, Quality quality) {
        return kind.isNormalMapped() && quality.normalMaps() == NormalMaps.ON;
    }

    public void bind(int block) {
        blocks.get(block).bind(UniformBlock.MATERIALS);
    }

    @Override
    public void close() {
        blocks.forEach(UniformBuffer::close);
    }
}
