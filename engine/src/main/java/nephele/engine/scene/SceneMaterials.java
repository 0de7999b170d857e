package nephele.engine.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Material;

/**
 * The level's materials by index, their pictures merged into arrays of one size each.
 *
 * @param surfaces index 0 is the default grey of faces without a material
 * @param colourArrays pictures in sRGB
 * @param normalArrays normal maps: linear, alpha multiplies roughness
 */
public record SceneMaterials(
        List<Surface> surfaces,
        List<PictureArray> colourArrays,
        List<PictureArray> normalArrays,
        Map<String, Integer> indexById) {
    /** Pictures of equal size, 8-bit RGBA. */
    public record PictureArray(int width, int height, List<Picture> layers) {}

    /** Where a picture is: which array, which layer. */
    public record Slot(int array, int layer) {
        public static final Slot NONE = new Slot(-1, 0);
    }

    /** A material with its pictures found. */
    public record Surface(Material material, Slot colour, Slot normal) {}

    /** @throws nephele.engine.asset.AssetException naming the picture that cannot be used */
    static SceneMaterials of(List<Material> materials, AssetSource assets) {
        Arrays colours = new Arrays(assets);
        Arrays normals = new Arrays(assets);
        List<Surface> surfaces = new ArrayList<>();
        Map<String, Integer> indexById = new HashMap<>();
        surfaces.add(new Surface(Material.DEFAULT_GREY, Slot.NONE, Slot.NONE));
        for (Material material : materials) {
            indexById.put(material.id(), surfaces.size());
            surfaces.add(
                    new Surface(material, colours.slot(material.texture()), normals.slot(material.normalTexture())));
        }
        return new SceneMaterials(List.copyOf(surfaces), colours.finished(), normals.finished(), Map.copyOf(indexById));
    }

    /** @param materialId {@code null} for the default grey */
    public int indexOf(String materialId) {
        return materialId == null ? 0 : indexById.getOrDefault(materialId, 0);
    }

    /** Collects pictures by size; one file is decoded once. */
    private static final class Arrays {
        private final AssetSource assets;
        private final Map<String, Slot> slots = new HashMap<>();
        private final Map<List<Integer>, Integer> arrayBySize = new LinkedHashMap<>();
        private final List<List<Picture>> arrays = new ArrayList<>();

        Arrays(AssetSource assets) {
            this.assets = assets;
        }

        Slot slot(String assetId) {
            if (assetId == null) {
                return Slot.NONE;
            }
            return slots.computeIfAbsent(assetId, this::add);
        }

        private Slot add(String assetId) {
            Picture picture =
                    PictureDecoder.decode(assetId, assets.bytes(assetId)).toRgba8();
            int array = arrayBySize.computeIfAbsent(List.of(picture.width(), picture.height()), size -> {
                arrays.add(new ArrayList<>());
                return arrays.size() - 1;
            });
            arrays.get(array).add(picture);
            return new Slot(array, arrays.get(array).size() - 1);
        }

        List<PictureArray> finished() {
            return arrays.stream()
                    .map(layers -> new PictureArray(
                            layers.get(0).width(), layers.get(0).height(), List.copyOf(layers)))
                    .toList();
        }
    }
}
