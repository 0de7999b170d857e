package nephele.engine.render.frame;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Material;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.SolidGeometry;

/** The numbers of the materials in uniform blocks, as {@code materials.glsl} reads them. */
public final class MaterialBlocks implements AutoCloseable {
    public static final int BINDING = 1;

    private static final int FLOATS_PER_MATERIAL = 16;

    private final List<UniformBuffer> blocks = new ArrayList<>();
    private final int materialsPerBlock;

    public MaterialBlocks(GlContext gl, List<Surface> surfaces) {
        materialsPerBlock = Math.min(surfaces.size(), SolidGeometry.MATERIALS_PER_BLOCK);
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
        put(values, at, m.baseColour(), m.roughness() == null ? 1 : m.roughness());
        put(values, at + 4, m.emission(), m.metallic() == null ? 0 : m.metallic());
        values[at + 8] = surface.colour().layer();
        values[at + 9] = surface.normal().layer();
        values[at + 10] = (float) m.textureMetres();
    }

    private static void put(float[] values, int at, Vec3 rgb, double fourth) {
        values[at] = (float) rgb.x();
        values[at + 1] = (float) rgb.y();
        values[at + 2] = (float) rgb.z();
        values[at + 3] = (float) fourth;
    }

    public int materialsPerBlock() {
        return materialsPerBlock;
    }

    public void bind(int block) {
        blocks.get(block).bind(BINDING);
    }

    @Override
    public void close() {
        blocks.forEach(UniformBuffer::close);
    }
}
