package nephele.engine.render.resource;

import java.lang.ref.WeakReference;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.SceneMaterials.PictureArray;
import org.lwjgl.system.MemoryUtil;

/** The scene's pictures as texture arrays with mipmaps, in the order of {@code SceneMaterials}. */
public record PictureArrays(List<Texture> textures) {
    /** Base colours, decoded from sRGB when sampled, except for output PLAIN. */
    public static final SharedResource<PictureArrays> COLOURS = SharedResource.of(
            "colours",
            context -> of(
                    context,
                    context.scene().materials().colourArrays(),
                    context.output().pictures()));

    /** Normal maps; alpha multiplies roughness. */
    public static final SharedResource<PictureArrays> NORMALS = SharedResource.of(
            "normal maps", context -> of(context, context.scene().materials().normalArrays(), PixelFormat.RGBA8));

    /**
     * Decodes assets. Passes that are built one after another share a picture; it can be garbage-collected afterwards.
     * Throws an {@link nephele.engine.asset.AssetException} that names a picture that cannot be used.
     */
    public static final SharedResource<Function<String, Picture>> DECODED =
            SharedResource.of("decoded pictures", PictureArrays::decoder);

    private static PictureArrays of(LoadContext context, List<PictureArray> arrays, PixelFormat format) {
        int anisotropy = anisotropy(context);
        return new PictureArrays(arrays.stream()
                .map(array -> context.share(
                        Texture.class,
                        List.of(new Identity(array), format, anisotropy),
                        () -> texture(context.gl(), array, format, anisotropy)))
                .toList());
    }

    /** Returns base colours of several sizes as one array of the greatest size. */
    public static Texture enlargedColours(LoadContext context, List<Picture> pictures) {
        return enlarged(context, pictures, context.output().pictures());
    }

    /** Returns normal maps of several sizes as one array of the greatest size. */
    public static Texture enlargedNormals(LoadContext context, List<Picture> pictures) {
        return enlarged(context, pictures, PixelFormat.RGBA8);
    }

    private static Texture enlarged(LoadContext context, List<Picture> pictures, PixelFormat format) {
        int width = pictures.stream().mapToInt(Picture::width).max().orElseThrow();
        int height = pictures.stream().mapToInt(Picture::height).max().orElseThrow();
        int anisotropy = anisotropy(context);
        return context.share(
                Texture.class,
                List.of(pictures.stream().map(Identity::new).toList(), format, anisotropy),
                () -> texture(
                        context.gl(),
                        new PictureArray(
                                width,
                                height,
                                pictures.parallelStream()
                                        .map(picture ->
                                                ResampledPicture.enlarged(picture, width, height, decoding(format)))
                                        .toList()),
                        format,
                        anisotropy));
    }

    /**
     * Mesa's llvmpipe 22.3 takes minutes for some pixels that have both several samples and anisotropic textures, and for
     * grounds, which sample theirs with explicit gradients.
     */
    private static int anisotropy(LoadContext context) {
        boolean isTooSlow = context.gl().limits().software()
                && (context.quality().samples() > 1
                        || !context.scene().statics().ground().isEmpty());
        return isTooSlow ? 1 : context.quality().anisotropy();
    }

    private static Function<String, Picture> decoder(LoadContext context) {
        AssetSource assets = context.scene().assets();
        Map<String, WeakReference<Picture>> decoded = new HashMap<>();
        return asset -> {
            WeakReference<Picture> known = decoded.get(asset);
            Picture picture = known == null ? null : known.get();
            if (picture == null) {
                picture = PictureDecoder.decode(asset, assets.bytes(asset));
                decoded.put(asset, new WeakReference<>(picture));
            }
            return picture;
        };
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
                .map(picture -> ResampledPicture.mipLevels(picture, decoding))
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
