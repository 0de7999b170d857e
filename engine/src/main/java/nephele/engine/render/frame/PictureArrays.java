package nephele.engine.render.frame;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.SceneMaterials.PictureArray;
import org.lwjgl.system.MemoryUtil;

/** The scene's pictures as texture arrays with mipmaps, in the order of {@code SceneMaterials}. */
public final class PictureArrays implements AutoCloseable {
    private final List<Texture> textures = new ArrayList<>();

    PictureArrays(GlContext gl, List<PictureArray> arrays, PixelFormat format, int anisotropy) {
        for (PictureArray array : arrays) {
            textures.add(texture(gl, array, format, anisotropy));
        }
    }

    private static Texture texture(GlContext gl, PictureArray array, PixelFormat format, int anisotropy) {
        Texture texture = new Texture(
                gl,
                "material pictures",
                Texture.Shape.ARRAY,
                format,
                new Texture.Extent(array.width(), array.height(), array.layers().size()),
                Sampling.MIPMAPPED_REPEAT);
        ByteBuffer texels = MemoryUtil.memAlloc(4 * array.width() * array.height());
        for (int layer = 0; layer < array.layers().size(); layer++) {
            Picture picture = array.layers().get(layer);
            texels.clear().put(picture.samples()).flip();
            texture.upload(layer, texels);
        }
        MemoryUtil.memFree(texels);
        texture.finishMipmaps(anisotropy);
        return texture;
    }

    public Texture get(int array) {
        return textures.get(array);
    }

    @Override
    public void close() {
        textures.forEach(Texture::close);
    }
}
