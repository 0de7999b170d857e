package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.level.Billboards;
import nephele.engine.level.billboard.AlphaCoverage;
import nephele.engine.level.billboard.Sprite;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** The pictures of billboards: an array for each size. Those with edges keep the drawn share in all mipmap levels. */
final class BillboardSprites implements GlObject {
    private final List<Texture> arrays = new ArrayList<>();
    private final Map<Look, Place> places = new HashMap<>();

    /** What a picture follows from. */
    private record Look(String sprite, Vec3 colourKey, int frames) {
        static Look of(Billboards group) {
            return new Look(group.sprite(), group.colourKey(), group.frames());
        }
    }

    /** Where a group's first frame is. */
    record Place(int array, int layer) {}

    /** @param keepsCoverage whether smaller mipmap levels keep the part of a picture that is drawn */
    BillboardSprites(GlContext gl, List<Billboards> groups, AssetSource assets, Output output, boolean keepsCoverage) {
        Map<Texture.Extent, List<Picture>> layers = new HashMap<>();
        List<Texture.Extent> sizes = new ArrayList<>();
        for (Billboards group : groups) {
            places.computeIfAbsent(Look.of(group), look -> {
                Sprite sprite = Sprite.of(group, assets);
                Texture.Extent size = Texture.Extent.flat(sprite.width(), sprite.height());
                if (!sizes.contains(size)) {
                    sizes.add(size);
                }
                List<Picture> all = layers.computeIfAbsent(size, none -> new ArrayList<>());
                all.addAll(sprite.frames());
                return new Place(
                        sizes.indexOf(size), all.size() - sprite.frames().size());
            });
        }
        sizes.forEach(size -> arrays.add(texture(gl, layers.get(size), output, keepsCoverage)));
    }

    private static Texture texture(GlContext gl, List<Picture> layers, Output output, boolean keepsCoverage) {
        int width = layers.get(0).width();
        int height = layers.get(0).height();
        Texture texture = new Texture(
                gl,
                "billboards",
                Texture.Shape.ARRAY,
                output.pictures(),
                new Texture.Extent(width, height, layers.size()),
                Sampling.MIPMAPPED_CLAMP);
        ByteBuffer texels = MemoryUtil.memAlloc(4 * width * height);
        try {
            for (int layer = 0; layer < layers.size(); layer++) {
                Picture picture = layers.get(layer);
                List<byte[]> levels = ResampledPicture.mipLevels(picture, output.decoding());
                texture.upload(layer, texels.clear().put(picture.samples()).flip());
                double coverage = AlphaCoverage.of(width, height, picture.samples());
                for (int level = 1; level <= levels.size(); level++) {
                    byte[] image = levels.get(level - 1);
                    if (keepsCoverage) {
                        AlphaCoverage.keep(coverage, Math.max(1, width >> level), Math.max(1, height >> level), image);
                    }
                    texture.uploadLevel(level, layer, texels.clear().put(image).flip());
                }
            }
        } finally {
            MemoryUtil.memFree(texels);
        }
        return texture;
    }

    Place place(Billboards group) {
        return places.get(Look.of(group));
    }

    void bind(int array) {
        arrays.get(array).bind(TextureUnit.COLOURS);
    }

    @Override
    public void close() {
        arrays.forEach(Texture::close);
    }
}
