package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** The plants of one kind that are drawn as meshes. */
public final class PlantList implements GlObject {
    private static final int PER_TEXEL = 4;

    private final BufferTexture texels;
    private FloatBuffer staging = MemoryUtil.memAllocFloat(64);
    private int count;

    public PlantList(GlContext gl) {
        texels = BufferTexture.changing(gl, "plant order");
    }

    public void begin() {
        count = 0;
        staging.clear();
    }

    /** Adds a plant by its number in {@link PlantedScene}. */
    public void add(int plant) {
        if (count + PER_TEXEL >= staging.capacity()) {
            staging = MemoryUtil.memRealloc(staging, 2 * staging.capacity());
        }
        staging.put(count++, plant);
    }

    public int count() {
        return count;
    }

    /** Draws the list with the current program. */
    public void draw(KindMesh mesh) {
        if (count == 0) {
            return;
        }
        int filled = (count + PER_TEXEL - 1) / PER_TEXEL * PER_TEXEL;
        for (int i = count; i < filled; i++) {
            staging.put(i, 0);
        }
        texels.upload(staging.limit(filled));
        texels.bind(TextureUnit.PLANT_ORDER);
        mesh.draw(count);
    }

    @Override
    public void close() {
        texels.close();
        MemoryUtil.memFree(staging);
    }
}
