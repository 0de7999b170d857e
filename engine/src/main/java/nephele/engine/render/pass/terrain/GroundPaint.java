package nephele.engine.render.pass.terrain;

import java.nio.ByteBuffer;
import nephele.engine.asset.LayerMap;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** The layer map of a terrain on the GPU. Its texels are fetched, not filtered, since indices have no mean. */
final class GroundPaint implements GlObject {
    private final LayerMap map;
    private final Texture texture;

    GroundPaint(GlContext gl, LayerMap map) {
        this.map = map;
        texture = new Texture(
                gl,
                "terrain layers",
                Texture.Shape.FLAT,
                PixelFormat.RG8,
                Texture.Extent.flat(map.columns(), map.rows()),
                Sampling.NEAREST_CLAMP);
        ByteBuffer texels = MemoryUtil.memAlloc(map.texels().length);
        texture.upload(0, texels.put(map.texels()).flip());
        MemoryUtil.memFree(texels);
    }

    LayerMap map() {
        return map;
    }

    void bind() {
        texture.bind(TextureUnit.TERRAIN_LAYERS);
    }

    @Override
    public void close() {
        texture.close();
    }
}
