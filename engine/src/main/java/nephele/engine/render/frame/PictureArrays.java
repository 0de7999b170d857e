package nephele.engine.render.frame;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.MipLevels;
import nephele.engine.render.resource.RepeatedScale;
import nephele.engine.scene.SceneMaterials.PictureArray;
import org.lwjgl.system.MemoryUtil;

/** The scene's pictures as texture arrays with mipmaps, in the order of {@code SceneMaterials}. */
public record PictureArrays(List<Texture> textures) {
    private record MadeFrom(Same array, PixelFormat format, int anisotropy) {}

    private record Enlarged(List<Same> pictures, PixelFormat format, int anisotropy) {}

    static PictureArrays of(
            GlContext gl, SharedResources shared, List<PictureArray> arrays, PixelFormat format, int anisotropy) {
        return new PictureArrays(arrays.stream()
                .map(array -> shared.share(
                        Texture.class,
                        new MadeFrom(new Same(array), format, anisotropy),
                        () -> texture(gl, array, format, anisotropy)))
                .toList());
    }

    /** Returns pictures of several sizes as one array, all of them as wide and as high as the widest and the highest. */
    static Texture enlarged(
            GlContext gl, SharedResources shared, List<Picture> pictures, PixelFormat format, int anisotropy) {
        int width = pictures.stream().mapToInt(Picture::width).max().orElseThrow();
        int height = pictures.stream().mapToInt(Picture::height).max().orElseThrow();
        return shared.share(
                Texture.class,
                new Enlarged(pictures.stream().map(Same::new).toList(), format, anisotropy),
                () -> texture(
                        gl,
                        new PictureArray(
                                width,
                                height,
                                pictures.parallelStream()
                                        .map(picture -> RepeatedScale.of(picture, width, height, decoding(format)))
                                        .toList()),
                        format,
                        anisotropy));
    }

    private static ColourDecoding decoding(PixelFormat format) {
        return format == PixelFormat.SRGB8_ALPHA8 ? ColourDecoding.SRGB : ColourDecoding.AS_STORED;
    }

    private static Texture texture(GlContext gl, PictureArray array, PixelFormat format, int anisotropy) {
        Texture texture = new Texture(
                gl,
                "material pictures",
                Texture.Shape.ARRAY,
                format,
                new Texture.Extent(array.width(), array.height(), array.layers().size()),
                Sampling.MIPMAPPED_REPEAT);
        ColourDecoding decoding = decoding(format);
        List<List<byte[]>> smaller = array.layers().parallelStream()
                .map(picture -> MipLevels.below(picture, decoding))
                .toList();
        ByteBuffer texels = MemoryUtil.memAlloc(4 * array.width() * array.height());
        for (int layer = 0; layer < array.layers().size(); layer++) {
            texture.upload(
                    layer,
                    texels.clear().put(array.layers().get(layer).samples()).flip());
            for (int level = 1; level <= smaller.get(layer).size(); level++) {
                byte[] image = smaller.get(layer).get(level - 1);
                texture.uploadLevel(level, layer, texels.clear().put(image).flip());
            }
        }
        MemoryUtil.memFree(texels);
        texture.anisotropy(anisotropy);
        return texture;
    }

    public Texture get(int array) {
        return textures.get(array);
    }
}
